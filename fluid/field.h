// Arrays of one value a cell (or a face), local to this rank, with ghost cells around them.
#pragma once

#include <algorithm>
#include <cstddef>

#include "fluid/grid.h"
#include "fluid/reals.h"

namespace swellflow {

/// Where a cell lies in memory. Direction 0 is contiguous; rows start on a 64-byte boundary, so that they can be transformed in place.
/// The face of a cell in direction d with index i is its lower one: the upper face of the last cell is the lower one of the first ghost.
template <int Dim> class Layout {
public:
  explicit Layout(const Grid<Dim> &grid) : cells_(grid.cells)
  {
    cells_[Dim - 1] = grid.planes;
    constexpr int ghost = Grid<Dim>::ghost;
    stride_[0] = 1;
    std::ptrdiff_t extent = (kPad + cells_[0] + ghost + kPad - 1) / kPad * kPad;
    origin_ = kPad;
    for (int d = 1; d < Dim; ++d) {
      stride_[d] = extent;
      origin_ += ghost * extent;
      extent *= cells_[d] + 2 * ghost;
    }
    size_ = static_cast<std::size_t>(extent) + kPad;  // the rows of a stencil are read in whole vectors (markers.cpp)
  }

  int cells(int d) const { return cells_[d]; }
  int planes() const { return cells_[Dim - 1]; }
  int rows() const { return Dim == 2 ? 1 : cells_[1]; }  ///< in a plane
  int row_length() const { return cells_[0]; }
  std::ptrdiff_t stride(int d) const { return stride_[d]; }
  std::ptrdiff_t plane_stride() const { return stride_[Dim - 1]; }
  std::size_t size() const { return size_; }

  /// First own cell of a row; plane may be a ghost.
  std::ptrdiff_t row(int plane, int r) const
  {
    std::ptrdiff_t at = origin_ + plane * stride_[Dim - 1];
    if constexpr (Dim == 3) at += r * stride_[1];
    return at;
  }
  /// Where the memory of a plane (a ghost or an own one, its ghost cells included) begins; it is plane_stride() long.
  std::ptrdiff_t plane_begin(int plane) const { return (plane + Grid<Dim>::ghost) * stride_[Dim - 1]; }

  std::ptrdiff_t at(const std::array<int, Dim> &cell) const
  {
    std::ptrdiff_t offset = origin_;
    for (int d = 0; d < Dim; ++d) offset += cell[d] * stride_[d];
    return offset;
  }

private:
  static constexpr int kPad = 8;  // doubles in 64 bytes
  std::array<int, Dim> cells_;
  std::array<std::ptrdiff_t, Dim> stride_{};
  std::ptrdiff_t origin_ = 0;
  std::size_t size_ = 0;
};

/// One double a cell; zero at first.
template <int Dim> class Field {
public:
  explicit Field(const Layout<Dim> &layout) : data_(allocate_reals(layout.size())) { std::fill_n(data_.get(), layout.size(), 0.0); }
  double *data() { return data_.get(); }
  const double *data() const { return data_.get(); }
  double &operator[](std::ptrdiff_t i) { return data_.get()[i]; }
  double operator[](std::ptrdiff_t i) const { return data_.get()[i]; }

private:
  Reals data_;
};

/// One field a direction: the components of a vector in the cells, or the normal components on the faces.
template <int Dim> class VectorField {
public:
  explicit VectorField(const Layout<Dim> &layout) : VectorField(layout, std::make_index_sequence<Dim>()) {}
  Field<Dim> &operator[](int c) { return components_[c]; }
  const Field<Dim> &operator[](int c) const { return components_[c]; }

private:
  template <std::size_t... I>
  VectorField(const Layout<Dim> &layout, std::index_sequence<I...>) : components_{((void)I, Field<Dim>(layout))...}
  {
  }
  std::array<Field<Dim>, Dim> components_;
};

}  // namespace swellflow
