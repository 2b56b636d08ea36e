// Direct solver for Helmholtz and Poisson problems on the grid: transforms within a plane, a tridiagonal sweep across the planes.
#pragma once

#include <fftw3.h>

#include <memory>

#include "fluid/field.h"
#include "fluid/slab_sweep.h"

namespace swellflow {

/// What a cell-centred unknown does at the two ends of a direction, both alike.
enum class End {
  value,    ///< zero on the wall, half a cell outside: the ghost is minus the first cell; DST-II/III
  gradient  ///< zero gradient: the ghost equals the first cell; DCT-II/III
};

/// Solves  a x - c L x = b  with the 2 Dim + 1 point Laplacian L, exactly up to round-off. Planes are transformed by FFTW row by row in the order of
/// the sweep, while they are in cache. Plans are made with FFTW_ESTIMATE: measured plans are about 10 % faster, but differ from
/// run to run, and with them the last bits of the result.
template <int Dim> class DirectSolver {
public:
  /// Collective.
  DirectSolver(const Grid<Dim> &grid, const Layout<Dim> &layout, const std::array<End, Dim> &ends);

  /// a >= 0; a = 0 with End::gradient everywhere leaves the mean free: it is taken out of b and of x. Collective.
  void set_operator(double a, double c);

  /// x is the solution in its own cells; ghosts are not touched. `fill(k)` writes b into plane k of x just before it is transformed,
  /// `take(k)` is called when plane k of the solution is there. Planes come in the order of the sweep and then back. Collective.
  template <class Fill, class Take> void solve(Field<Dim> &x, Fill &&fill, Take &&take)
  {
    const int planes = layout_.planes();
    for (int s = 0; s < planes; ++s) {
      fill(sweep_->plane(s));
      forward(s, x);
    }
    sweep_->meet();
    for (int s = planes - 1; s >= 0; --s) {
      backward(s, x);
      take(sweep_->plane(s));
    }
  }

private:
  struct DestroyPlan {
    void operator()(fftw_plan p) const { fftw_destroy_plan(p); }
  };
  using Plan = std::unique_ptr<std::remove_pointer_t<fftw_plan>, DestroyPlan>;
  Plan plan(fftw_r2r_kind for_value, fftw_r2r_kind for_gradient, double *buffer) const;
  void forward(int s, Field<Dim> &x);
  void backward(int s, Field<Dim> &x);

  const Grid<Dim> &grid_;
  const Layout<Dim> &layout_;
  std::array<End, Dim> ends_;
  Plan to_modes_, to_cells_;
  std::unique_ptr<SlabSweep> sweep_;
};

extern template class DirectSolver<2>;
extern template class DirectSolver<3>;

}  // namespace swellflow
