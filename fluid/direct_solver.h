// Direct solver for Helmholtz and Poisson problems on the grid: transforms within a plane, a tridiagonal sweep across the planes.
#pragma once

#include <memory>

#include "fluid/field.h"
#include "fluid/row_transform.h"
#include "fluid/slab_sweep.h"

namespace swellflow {

/// By direction: what an unknown does at the ends.
template <int Dim> using AllEnds = std::array<Ends, Dim>;

/// The operator  a x - c L x  with the 2 Dim + 1 point Laplacian L, for unknowns with given ends. Inverted exactly, up to round-off.
template <int Dim> class DirectSolver {
public:
  /// Collective.
  DirectSolver(const Grid<Dim> &grid, const Layout<Dim> &layout, const AllEnds<Dim> &ends);

  /// a >= 0; with a = 0 and no End::value anywhere the mean is free: it is taken out of b and of x. Collective.
  void set_operator(double a, double c);

  const AllEnds<Dim> &ends() const { return ends_; }

private:
  template <int, std::size_t> friend class JointSolve;
  struct DestroyPlan {
    void operator()(fftw_plan p) const { fftw_destroy_plan(p); }
  };
  using Plan = std::unique_ptr<std::remove_pointer_t<fftw_plan>, DestroyPlan>;
  Plan plan_across_rows(bool to_modes) const;

  const Grid<Dim> &grid_;
  const Layout<Dim> &layout_;
  AllEnds<Dim> ends_;
  SlabSweep sweep_;
  Plan to_modes_across_, to_cells_across_;  // 3-D: along direction 1 of a plane
};

/// N problems on the same grid that are solved in one sweep over the planes, so that what belongs to a plane is done while it is in cache: its rows are transformed
/// two by two, of two unknowns or of two planes, and eliminated at once. Unknowns may share a solver.
template <int Dim, std::size_t N> class JointSolve {
public:
  JointSolve(const Layout<Dim> &layout, const std::array<std::shared_ptr<DirectSolver<Dim>>, N> &solvers);

  /// x[c] is the solution for component c in its own cells; ghosts are not touched. `fill(k)` writes the right-hand sides into plane k of all x just before they are
  /// transformed, `take(k)` is called when plane k of all solutions is there. Planes come in the order of the sweep and then back. Collective.
  template <class Fill, class Take> void operator()(const std::array<Field<Dim> *, N> &x, Fill &&fill, Take &&take)
  {
    const int planes = layout_.planes();
    for (int s = 0; s < planes; s += batch) {
      const int end = std::min(s + batch, planes);
      for (int t = s; t < end; ++t) fill(plane(t));
      forward(x, s, end);
    }
    for (std::size_t c = 0; c < N; ++c) solvers_[c]->sweep_.meet(unknowns_[c]);
    for (int s = (planes - 1) / batch * batch; s >= 0; s -= batch) {
      const int end = std::min(s + batch, planes);
      backward(x, s, end);
      for (int t = end - 1; t >= s; --t) take(plane(t));
    }
  }

private:
  /// Planes that are transformed together: as many as make an even number of rows.
  static constexpr int batch = N % 2 ? 2 : 1;
  int plane(int s) const { return solvers_[0]->sweep_.plane(s); }
  void forward(const std::array<Field<Dim> *, N> &x, int s, int end);
  void backward(const std::array<Field<Dim> *, N> &x, int s, int end);
  template <class Transform> void two_by_two(const std::array<Field<Dim> *, N> &x, int s, int end, Transform &&transform);

  const Layout<Dim> &layout_;
  std::array<std::shared_ptr<DirectSolver<Dim>>, N> solvers_;
  std::array<SlabSweep::Unknown, N> unknowns_;
  RowTransform transform_;
};

extern template class DirectSolver<2>;
extern template class DirectSolver<3>;
extern template class JointSolve<2, 1>;
extern template class JointSolve<2, 2>;
extern template class JointSolve<3, 1>;
extern template class JointSolve<3, 3>;

}  // namespace swellflow
