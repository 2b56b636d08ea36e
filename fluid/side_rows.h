// Loops over the cells along the sides of the box.
#pragma once

#include "fluid/boundaries.h"

namespace swellflow {

/// Rows of plane k that hold cells of the side: all of them in direction 0 and in the last, one in a middle direction.
template <int Dim> int BoundaryValues<Dim>::rows_of(int side, int k) const
{
  const int d = side / 2;
  if (d == Dim - 1) return k == (side % 2 ? layout_.planes() - 1 : 0) ? layout_.rows() : 0;
  return d == 0 ? layout_.rows() : 1;
}

template <int Dim> std::ptrdiff_t BoundaryValues<Dim>::inner_cell(int side, int k, int r) const
{
  const int d = side / 2;
  if (d == 0) return layout_.row(k, r) + (side % 2 ? layout_.row_length() - 1 : 0);
  return layout_.row(k, d == Dim - 1 ? r : (side % 2 ? layout_.rows() - 1 : 0));
}

template <int Dim> std::size_t BoundaryValues<Dim>::index(int side, int k, int r) const
{
  const std::size_t row = side / 2 == Dim - 1 ? r : side / 2 == 0 ? static_cast<std::size_t>(k) * layout_.rows() + r : k;
  return row * cells_in_row(side);
}

/// f(index of the first value, offset of the first inner cell, number of cells)
template <int Dim> template <class F> void BoundaryValues<Dim>::each_row_in_plane(int side, int k, F &&f) const
{
  for (int r = 0; r < rows_of(side, k); ++r) f(index(side, k, r), inner_cell(side, k, r), cells_in_row(side));
}

template <int Dim> template <class F> void BoundaryValues<Dim>::each_row(int side, F &&f) const
{
  if (!is_here(side)) return;
  for (int k = 0; k < layout_.planes(); ++k) each_row_in_plane(side, k, f);
}

}  // namespace swellflow
