// Ghost planes between neighbouring slabs. A plane is contiguous, so nothing is packed.
#pragma once

#include <vector>

#include "fluid/field.h"

namespace swellflow {

template <int Dim> class Halo {
public:
  Halo(const Grid<Dim> &grid, const Layout<Dim> &layout)
      : grid_(grid), layout_(layout), received_(2 * Grid<Dim>::ghost * layout.plane_stride())
  {
  }

  /// The `width` ghost planes on either side take the neighbours' own planes, side ghosts included. Collective.
  void fill(Field<Dim> &field, int width) const
  {
    if (grid_.ranks == 1) return;
    const int n = static_cast<int>(width * layout_.plane_stride());
    const int top = layout_.planes();
    shift(plane(field, top - width), grid_.rank_above(), plane(field, -width), grid_.rank_below(), n);
    shift(plane(field, 0), grid_.rank_below(), plane(field, top), grid_.rank_above(), n);
  }

  /// What was added to the ghost planes goes to their owners; all ghost planes are then filled with the sums. Collective.
  void add(Field<Dim> &field)
  {
    if (grid_.ranks == 1) return;
    constexpr int width = Grid<Dim>::ghost;
    const std::ptrdiff_t n = width * layout_.plane_stride();
    const int top = layout_.planes();
    double *from_below = received_.data(), *from_above = received_.data() + n;
    shift(plane(field, top), grid_.rank_above(), from_below, grid_.rank_below(), static_cast<int>(n));
    shift(plane(field, -width), grid_.rank_below(), from_above, grid_.rank_above(), static_cast<int>(n));
    if (!grid_.at_lower_end()) accumulate(plane(field, 0), from_below, n);
    if (!grid_.at_upper_end()) accumulate(plane(field, top - width), from_above, n);
    fill(field, width);
  }

private:
  double *plane(Field<Dim> &field, int k) const { return field.data() + layout_.plane_begin(k); }
  void shift(const double *send, int to, double *receive, int from, int n) const
  {
    MPI_Sendrecv(send, n, MPI_DOUBLE, to, 0, receive, n, MPI_DOUBLE, from, 0, grid_.comm, MPI_STATUS_IGNORE);
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
