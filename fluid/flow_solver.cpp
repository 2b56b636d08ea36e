#include "fluid/flow_solver.h"

#include <utility>

#include "fluid/flow_faces.h"

namespace swellflow {

template <int Dim>
FlowSolver<Dim>::FlowSolver(const Grid<Dim> &grid, const FluidProperties &fluid, const Boundaries<Dim> &boundaries, Advection advection)
    : grid_(grid), layout_(grid_), halo_(grid_, layout_), fluid_(fluid), sides_(grid_, layout_, boundaries),
      side_impulses_(sides_, grid_, layout_, fluid.density, fluid.kinematic_viscosity, advection), advection_scheme_(advection), u_(layout_), u_star_(layout_),
      face_velocity_(layout_), advection_(layout_), p_(layout_), phi_(layout_), forcing_(grid_, layout_), viscous_(viscous_solvers()),
      poisson_(std::make_shared<DirectSolver<Dim>>(grid_, layout_, sides_.pressure_ends())), solve_viscous_(layout_, viscous_), solve_poisson_(layout_, {poisson_})
{
  poisson_->set_operator(0.0, -1.0);
}

/// Components with the same ends share one.
template <int Dim> std::array<typename FlowSolver<Dim>::Solver, Dim> FlowSolver<Dim>::viscous_solvers() const
{
  std::array<Solver, Dim> solvers;
  for (int c = 0; c < Dim; ++c) {
    const AllEnds<Dim> ends = sides_.velocity_ends(c);
    for (int other = 0; other < c; ++other)
      if (solvers[other]->ends() == ends) solvers[c] = solvers[other];
    if (!solvers[c]) solvers[c] = std::make_shared<DirectSolver<Dim>>(grid_, layout_, ends);
  }
  return solvers;
}

template <int Dim> void FlowSolver<Dim>::set_body_force(const Vec<Dim> &g)
{
  for (int d = 0; d < Dim; ++d) body_force_[d] = grid_.periodic[d] ? g[d] : 0.0;
}

template <int Dim> void FlowSolver<Dim>::start_from_velocity()
{
  sides_.start(u_);
  sides_.fill_velocity(u_, 1, halo_);
  sides_.set_faces(face_velocity_);
  dt_before_ = 0.0;
  each_face_row([&](int d, std::ptrdiff_t o, int first, int end) {
    const double *u = u_[d].data() + o;
    double *face = face_velocity_[d].data() + o;
    const std::ptrdiff_t s = layout_.stride(d);
    for (int i = first; i < end; ++i) face[i] = 0.5 * (u[i] + u[i - s]);
  });
}

template <int Dim> void FlowSolver<Dim>::start_with_velocity(const Vec<Dim> &velocity)
{
  for (int c = 0; c < Dim; ++c)
    for (int k = 0; k < layout_.planes(); ++k)
      for (int r = 0; r < layout_.rows(); ++r) std::fill_n(u_[c].data() + layout_.row(k, r), layout_.row_length(), velocity[c]);
  start_from_velocity();
}

/// A cell receives the mean of its two faces.
template <int Dim> void FlowSolver<Dim>::add_forcing_to_cells(int k)
{
  if (!forcing_.touches_neighbourhood(k)) return;
  for (int r = 0; r < layout_.rows(); ++r)
    for (int c = 0; c < Dim; ++c) {
      const std::ptrdiff_t o = layout_.row(k, r), s = layout_.stride(c);
      const double *f = forcing_.faces(c) + o;
      double *u = u_star_[c].data() + o;
      for (int i = 0; i < layout_.row_length(); ++i) u[i] += 0.5 * (f[i] + f[i + s]);
    }
}

template <int Dim> void FlowSolver<Dim>::apply_forcing()
{
  PhaseClock::Scope phase(clock_, PhaseClock::forcing);
  for (int k = 0; k < layout_.planes(); ++k) add_forcing_to_cells(k);
  each_face_row([&](int d, std::ptrdiff_t o, int first, int end) {
    if (!forcing_.touches_neighbourhood(plane_of(o))) return;
    const double *f = forcing_.faces(d) + o;
    double *face = face_velocity_[d].data() + o;
    for (int i = first; i < end; ++i) face[i] += f[i];
  });
}

template <int Dim> CellSources<Dim> &FlowSolver<Dim>::sources()
{
  if (!sources_ && !sides_.has_outflow()) throw std::invalid_argument("what appears within the box must be able to leave, but it has no outflow; make a side an outflow");
  if (!sources_) sources_.emplace(grid_, layout_);
  return *sources_;
}

// ---- projection ------------------------------------------------------------------------------------------------------------------------------

template <int Dim> void FlowSolver<Dim>::divergence_plane(int k)
{
  const int n = layout_.row_length();
  const double scale = 1.0 / (grid_.h * dt_);
  for (int r = 0; r < layout_.rows(); ++r) {
    const std::ptrdiff_t o = layout_.row(k, r);
    double *row = phi_.data() + o;
    for (int d = 0; d < Dim; ++d) {
      const double *face = face_velocity_[d].data() + o;
      const std::ptrdiff_t s = layout_.stride(d);
#pragma GCC ivdep
      for (int i = 0; i < n; ++i) row[i] = (d ? row[i] : 0.0) + scale * (face[i + s] - face[i]);
    }
    if (!sources_) continue;
    const double *source = sources_->rate() + o;
    for (int i = 0; i < n; ++i) row[i] -= source[i] / dt_;
  }
}

template <int Dim> void FlowSolver<Dim>::project(double dt)
{
  make_divergence_free(dt);
  side_impulses_.end_step(p_, face_velocity_);
  std::swap(u_, u_star_);
  sides_.end_step();
  dt_before_ = dt;
}

template <int Dim> void FlowSolver<Dim>::make_divergence_free(double dt)
{
  dt_ = dt;
  PhaseClock::Scope phase(clock_, PhaseClock::projection);
  if (sources_) {
    sides_.let_out(sources_->total());
    sides_.set_faces(face_velocity_);
  }
  const auto faces = [this](int d, std::ptrdiff_t o, int first, int end) { correct_face_row(d, o, first, end); };
  int taken = -1, taken_before = -1;
  {
    PhaseClock::Scope solves(clock_, PhaseClock::solves);
    solve_poisson_(
        {&phi_},
        [&](int k) {
          PhaseClock::Scope scope(clock_, PhaseClock::projection);
          divergence_plane(k);
        },
        [&](int k) {
          PhaseClock::Scope scope(clock_, PhaseClock::projection);
          sides_.fill_scalar_plane(phi_, k, 1, halo_);
          each_face_row_in_plane(k, faces);
          if (taken >= 0) each_face_row_below_plane(std::max(k, taken), faces);
          if (taken_before >= 0) correct_plane(taken);
          taken_before = std::exchange(taken, k);
        });
  }
  {
    PhaseClock::Scope halo(clock_, PhaseClock::halo);
    sides_.fill_scalar_ends(phi_, 1, halo_);
  }
  for (const int k : {0, layout_.planes()})
    if (inner_faces(k)) each_face_row_below_plane(k, faces);
  for (const int k : {0, layout_.planes() - 1}) correct_plane(k);
}

template <int Dim> void FlowSolver<Dim>::correct_face_row(int d, std::ptrdiff_t o, int first, int end)
{
  const double gradient = dt_ / grid_.h;
  const double *phi = phi_.data() + o;
  double *face = face_velocity_[d].data() + o;
  const std::ptrdiff_t s = layout_.stride(d);
#pragma GCC ivdep
  for (int i = first; i < end; ++i) face[i] -= gradient * (phi[i] - phi[i - s]);
}

template <int Dim> void FlowSolver<Dim>::correct_plane(int k)
{
  const double gradient = 0.5 * dt_ / grid_.h;
  const int n = layout_.row_length();
  for (int r = 0; r < layout_.rows(); ++r) {
    const std::ptrdiff_t o = layout_.row(k, r);
    const double *phi = phi_.data() + o;
    double *p = p_.data() + o;
    for (int c = 0; c < Dim; ++c) {
      double *u = u_star_[c].data() + o;
      const std::ptrdiff_t s = layout_.stride(c);
#pragma GCC ivdep
      for (int i = 0; i < n; ++i) u[i] -= gradient * (phi[i + s] - phi[i - s]);
    }
#pragma GCC ivdep
    for (int i = 0; i < n; ++i) p[i] += phi[i];
  }
}

template <int Dim> const VectorField<Dim> &FlowSolver<Dim>::face_velocity_around()
{
  PhaseClock::Scope phase(clock_, PhaseClock::halo);
  for (int c = 0; c < Dim; ++c) {
    halo_.wrap(face_velocity_[c], Grid<Dim>::ghost);
    halo_.fill(face_velocity_[c], Grid<Dim>::ghost);
  }
  return face_velocity_;
}

template class FlowSolver<2>;

}  // namespace swellflow
