// Fluid that appears within the box.
#pragma once

#include <cmath>

#include "fluid/halo.h"

namespace swellflow {

class Checkpoint;

/// The volume that appears in each cell, per time and per volume of the cell [1/time]: the divergence that the projection leaves there.
template <int Dim> class CellSources {
public:
  CellSources(const Grid<Dim> &grid, const Layout<Dim> &layout) : grid_(grid), layout_(layout), halo_(grid, layout), rate_(layout) {}

  void clear()
  {
    std::fill_n(rate_.data(), layout_.size(), 0.0);
    total_ = 0.0;
  }

  /// A source [length^Dim / time] at a point of this rank's slab, shared by the cells around it in linear weights; beyond the centres of the cells at a side those have all of it. In a
  /// periodic direction any image of the point will do.
  void add(const Vec<Dim> &position, double rate)
  {
    std::array<int, Dim> lower;
    Vec<Dim> upper_share;
    for (int d = 0; d < Dim; ++d) {
      const int begin = d == Grid<Dim>::last ? grid_.first_plane : 0;
      double x = (position[d] - grid_.origin[d]) / grid_.h;
      if (grid_.periodic[d]) x -= grid_.cells[d] * std::floor((x - begin - 0.5 * layout_.cells(d)) / grid_.cells[d] + 0.5);
      else x = std::clamp(x, 0.5, grid_.cells[d] - 0.5);
      const int cell = std::clamp(static_cast<int>(std::floor(x - 0.5)), begin - 1, begin + layout_.cells(d) - 1);
      upper_share[d] = x - 0.5 - cell;
      lower[d] = cell - begin;
    }
    const double per_volume = rate / grid_.cell_volume();
    for (int corner = 0; corner < 1 << Dim; ++corner) {
      double weight = per_volume;
      std::ptrdiff_t at = layout_.at(lower);
      for (int d = 0; d < Dim; ++d) {
        const bool upper = corner >> d & 1;
        weight *= upper ? upper_share[d] : 1.0 - upper_share[d];
        if (upper) at += layout_.stride(d);
      }
      rate_[at] += weight;
    }
    total_ += rate;
  }

  /// Joins what was added on both sides of slab borders and of periodic ones. Collective.
  void complete()
  {
    halo_.add(rate_);
    for (int k = 0; k < layout_.planes(); ++k) halo_.fold(rate_, k);
    MPI_Allreduce(MPI_IN_PLACE, &total_, 1, MPI_DOUBLE, MPI_SUM, grid_.comm);
  }

  void keep(Checkpoint &file);  ///< collective

  const double *rate() const { return rate_.data(); }
  double total() const { return total_; }  ///< of all ranks, after `complete`

private:
  const Grid<Dim> &grid_;
  const Layout<Dim> &layout_;
  Halo<Dim> halo_;
  Field<Dim> rate_;
  double total_ = 0.0;
};

}  // namespace swellflow
