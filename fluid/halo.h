// Ghost cells: those between neighbouring slabs, and those that periodic directions have within a slab.
#pragma once

#include <vector>

#include "fluid/field.h"

namespace swellflow {

/// A plane is contiguous, so planes are sent as they are, side ghosts included. Hence the order:
///     values:  `wrap`, then `fill`: a plane's own ghost cells are right before it is sent
///     sums:    `add`, then `fold` of each plane, then `fill`: what came from neighbours lies in own planes before these are folded
/// Both do the directions in turn, 0 first when values are copied out and 0 last when sums come in, so that corners are right as well.
template <int Dim> class Halo {
public:
  static constexpr int ghost = Grid<Dim>::ghost;

  /// Throws std::invalid_argument (on every rank alike) when a periodic direction has fewer cells than ghosts.
  Halo(const Grid<Dim> &grid, const Layout<Dim> &layout) : grid_(grid), layout_(layout), received_(2 * ghost * layout.plane_stride())
  {
    for (int d = 0; d < Dim; ++d)
      if (grid.periodic[d] && grid.cells[d] < ghost)
        throw std::invalid_argument("a periodic direction of the fluid needs at least " + std::to_string(ghost) + " cells, but direction " +
                                    std::to_string(d) + " has " + std::to_string(grid.cells[d]) + "; use more cells");
  }

  /// Whether any ghost plane has an owner: another rank, or this one where it alone is periodic.
  bool has_neighbours() const { return grid_.rank_below() != MPI_PROC_NULL || grid_.rank_above() != MPI_PROC_NULL; }

  /// In own planes, the `width` ghost cells on either side of periodic directions take the values of the cells that they stand for.
  void wrap(Field<Dim> &field, int width) const
  {
    for (int k = 0; k < layout_.planes(); ++k) wrap_plane(field, k, width);
  }

  /// The same in own plane k alone.
  void wrap_plane(Field<Dim> &field, int k, int width) const
  {
    for (int d = 0; d < Dim - 1; ++d)
      each_ghost(k, d, width, [&](std::ptrdiff_t to, std::ptrdiff_t from, std::ptrdiff_t n) { std::copy_n(field.data() + from, n, field.data() + to); });
  }

  /// The `width` ghost planes on either side take the neighbours' own planes, side ghosts included. Collective.
  void fill(Field<Dim> &field, int width) const
  {
    if (!has_neighbours()) return;
    const int n = static_cast<int>(width * layout_.plane_stride());
    const int top = layout_.planes();
    shift(plane(field, top - width), grid_.rank_above(), plane(field, -width), grid_.rank_below(), n);
    shift(plane(field, 0), grid_.rank_below(), plane(field, top), grid_.rank_above(), n);
  }

  /// What was added to the ghost planes, their ghost cells included, is added to the planes' owners. Collective.
  void add(Field<Dim> &field)
  {
    if (!has_neighbours()) return;
    const std::ptrdiff_t n = ghost * layout_.plane_stride();
    const int top = layout_.planes();
    double *from_below = received_.data(), *from_above = received_.data() + n;
    shift(plane(field, top), grid_.rank_above(), from_below, grid_.rank_below(), static_cast<int>(n));
    shift(plane(field, -ghost), grid_.rank_below(), from_above, grid_.rank_above(), static_cast<int>(n));
    if (!grid_.at_lower_end()) accumulate(plane(field, 0), from_below, n);
    if (!grid_.at_upper_end()) accumulate(plane(field, top - ghost), from_above, n);
  }

  /// What was added to ghost cells of periodic directions within own plane k is added to the cells that they stand for; they then hold the sums.
  void fold(Field<Dim> &field, int k) const
  {
    for (int d = Dim - 2; d >= 0; --d)
      each_ghost(k, d, ghost, [&](std::ptrdiff_t from, std::ptrdiff_t to, std::ptrdiff_t n) { accumulate(field.data() + to, field.data() + from, n); });
    wrap_plane(field, k, ghost);
  }

private:
  double *plane(Field<Dim> &field, int k) const { return field.data() + layout_.plane_begin(k); }

  void shift(const double *send, int to, double *receive, int from, int n) const
  {
    if (to == grid_.rank)
      std::copy_n(send, n, receive);
    else
      MPI_Sendrecv(send, n, MPI_DOUBLE, to, 0, receive, n, MPI_DOUBLE, from, 0, grid_.comm, MPI_STATUS_IGNORE);
  }

  /// f(ghost, owner, n): n contiguous ghosts of direction d in plane k and the cells that they stand for. In direction 0 those of own rows, one
  /// by one; in direction 1 of a 3-D grid whole rows, ghost cells included.
  template <class F> void each_ghost(int k, int d, int width, F &&f) const
  {
    if (!grid_.periodic[d]) return;
    const std::ptrdiff_t s = layout_.stride(d);
    const int n = layout_.cells(d), lines = d == 0 ? layout_.rows() : 1;
    for (int r = 0; r < lines; ++r) {
      const std::ptrdiff_t first = d == 0 ? layout_.row(k, r) : layout_.plane_begin(k) + ghost * s;
      for (int g = 0; g < width; ++g) {
        f(first - (g + 1) * s, first + (n - g - 1) * s, s);
        f(first + (n + g) * s, first + g * s, s);
      }
    }
  }

  static void accumulate(double *sum, const double *part, std::ptrdiff_t n)
  {
    for (std::ptrdiff_t i = 0; i < n; ++i) sum[i] += part[i];
  }

  const Grid<Dim> &grid_;
  const Layout<Dim> &layout_;
  std::vector<double> received_;
};

}  // namespace swellflow
