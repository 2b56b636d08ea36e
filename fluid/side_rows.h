// Loops over the cells along the sides of the box.
#pragma once

#include "fluid/field.h"

namespace swellflow {

/// Side 2 d is the lower and 2 d + 1 the upper end of direction d.
template <int Dim> class SideRows {
public:
  SideRows(const Grid<Dim> &grid, const Layout<Dim> &layout) : grid_(grid), layout_(layout) {}

  /// Whether this rank has the cells of a side, or some of them.
  bool reach(int side) const
  {
    if (side / 2 < Dim - 1) return true;
    return grid_.rank == (side % 2 ? grid_.ranks - 1 : 0);
  }

  /// f(index of the first value, offset of the first inner cell, number of cells) for the rows of plane k.
  template <class F> void each_in_plane(int side, int k, F &&f) const
  {
    for (int r = 0; r < rows_of(side, k); ++r) f(index(side, k, r), inner_cell(side, k, r), cells_in_row(side));
  }
  /// The same for all of this rank's planes.
  template <class F> void each(int side, F &&f) const
  {
    if (!reach(side)) return;
    for (int k = 0; k < layout_.planes(); ++k) each_in_plane(side, k, f);
  }
  /// From a cell to the one beyond the side.
  std::ptrdiff_t outwards(int side) const { return (side % 2 ? 1 : -1) * layout_.stride(side / 2); }
  /// From an inner cell to its face on the side.
  std::ptrdiff_t face(int side) const { return side % 2 ? layout_.stride(side / 2) : 0; }

private:
  /// Rows of plane k that hold cells of the side: all of them in direction 0 and in the last, one in a middle direction.
  int rows_of(int side, int k) const
  {
    const int d = side / 2;
    if (d == Dim - 1) return k == (side % 2 ? layout_.planes() - 1 : 0) ? layout_.rows() : 0;
    return d == 0 ? layout_.rows() : 1;
  }

  std::ptrdiff_t inner_cell(int side, int k, int r) const
  {
    const int d = side / 2;
    if (d == 0) return layout_.row(k, r) + (side % 2 ? layout_.row_length() - 1 : 0);
    return layout_.row(k, d == Dim - 1 ? r : (side % 2 ? layout_.rows() - 1 : 0));
  }

  std::size_t index(int side, int k, int r) const
  {
    const std::size_t row = side / 2 == Dim - 1 ? r : side / 2 == 0 ? static_cast<std::size_t>(k) * layout_.rows() + r : k;
    return row * cells_in_row(side);
  }

  int cells_in_row(int side) const { return side / 2 == 0 ? 1 : layout_.row_length(); }

  const Grid<Dim> &grid_;
  const Layout<Dim> &layout_;
};

}  // namespace swellflow
