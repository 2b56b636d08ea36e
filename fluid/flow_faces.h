// Loops over the faces of a slab that lie between two cells.
#pragma once

#include "fluid/flow_solver.h"

namespace swellflow {

template <int Dim> template <class F> void FlowSolver<Dim>::each_face_row_in_plane(int k, F &&f) const
{
  const int n = layout_.row_length();
  const int first = grid_.periodic[0] ? 0 : 1, end = grid_.periodic[0] ? n + 1 : n;
  for (int r = 0; r < layout_.rows(); ++r) f(0, layout_.row(k, r), first, end);
  if constexpr (Dim == 3) {
    const int first_row = grid_.periodic[1] ? 0 : 1, end_row = grid_.periodic[1] ? layout_.rows() + 1 : layout_.rows();
    for (int r = first_row; r < end_row; ++r) f(1, layout_.row(k, r), 0, n);
  }
}

template <int Dim> template <class F> void FlowSolver<Dim>::each_face_row_below_plane(int k, F &&f) const
{
  for (int r = 0; r < layout_.rows(); ++r) f(Dim - 1, layout_.row(k, r), 0, layout_.row_length());
}

template <int Dim> template <class F> void FlowSolver<Dim>::each_face_row(F &&f) const
{
  for (int k = 0; k <= layout_.planes(); ++k) {
    if (own(k)) each_face_row_in_plane(k, f);
    if (inner_faces(k)) each_face_row_below_plane(k, f);
  }
}

}  // namespace swellflow
