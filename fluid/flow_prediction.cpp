// The first half of the fluid's step: right-hand sides, viscous solves, velocities on faces.
#include <utility>

#include "fluid/flow_faces.h"
#include "fluid/flow_solver.h"

namespace swellflow {

namespace {

template <int Dim> std::array<Field<Dim> *, Dim> pointers(VectorField<Dim> &field)
{
  std::array<Field<Dim> *, Dim> result;
  for (int c = 0; c < Dim; ++c) result[c] = &field[c];
  return result;
}

}  // namespace

template <int Dim> void FlowSolver<Dim>::factor_viscous(double dt)
{
  if (dt == dt_factored_) return;
  for (int c = 0; c < Dim; ++c)
    if (c == 0 || viscous_[c] != viscous_[0]) viscous_[c]->set_operator(1.0, 0.5 * fluid_.kinematic_viscosity * dt);
  dt_factored_ = dt;
}

template <int Dim> void FlowSolver<Dim>::predict_velocity(double dt)
{
  dt_ = dt;
  alpha_ = 1.0 / (1.0 + 4.0 * fluid_.kinematic_viscosity * dt / (grid_.h * grid_.h));
  const auto faces = [this](int d, std::ptrdiff_t o, int first, int end) { interpolate_row(d, o, first, end); };
  PhaseClock::Scope phase(clock_, PhaseClock::prediction);
  factor_viscous(dt);
  sides_.advance(dt, u_);
  {
    PhaseClock::Scope halo(clock_, PhaseClock::halo);
    sides_.fill_velocity(u_, advection_scheme_ == Advection::bounded ? 2 : 1, halo_);
    for (int k = 0; k < layout_.planes(); ++k) sides_.fill_scalar_plane(p_, k, 2, halo_);
    sides_.fill_scalar_ends(p_, 2, halo_);
  }
  side_impulses_.begin_step(dt, dt_before_, u_, face_velocity_);
  if (sources_) begin_source_momentum();
  int taken = -1;
  {
    PhaseClock::Scope solves(clock_, PhaseClock::solves);
    solve_viscous_(
        pointers(u_star_),
        [&](int k) {
          PhaseClock::Scope scope(clock_, PhaseClock::prediction);
          predict_plane(k);
        },
        [&](int k) {
          PhaseClock::Scope scope(clock_, PhaseClock::prediction);
          for (int d = 0; d < Dim - 1; ++d) halo_.wrap_plane(u_star_[d], k, 1);
          each_face_row_in_plane(k, faces);
          if (taken >= 0) each_face_row_below_plane(std::max(k, taken), faces);
          taken = k;
        });
  }
  {
    PhaseClock::Scope halo(clock_, PhaseClock::halo);
    halo_.fill(u_star_[Dim - 1], 1);
  }
  for (const int k : {0, layout_.planes()})
    if (inner_faces(k)) each_face_row_below_plane(k, faces);
  sides_.set_faces(face_velocity_);
  side_impulses_.add_implicit_viscosity(u_star_);
}

// The right-hand sides of all components in plane k; H^n takes the place of H^(n-1).
template <int Dim> void FlowSolver<Dim>::predict_plane(int k)
{
  for (int r = 0; r < layout_.rows(); ++r) {
    switch (advection_scheme_) {
      case Advection::central: predict_row<Advection::central>(k, r); break;
      case Advection::bounded: predict_row<Advection::bounded>(k, r); break;
      case Advection::none: predict_row<Advection::none>(k, r); break;
    }
  }
  if (sources_ && advection_scheme_ != Advection::none) add_source_momentum(k);
  add_forcing_to_cells(k);
  // The known part of the ghosts, twice the velocity on the side, in the implicit half of viscosity.
  for (int c = 0; c < Dim; ++c) sides_.add_given(c, k, fluid_.kinematic_viscosity * dt_ / (grid_.h * grid_.h), u_star_[c]);
}

template <int Dim> void FlowSolver<Dim>::begin_source_momentum()
{
  const double ratio = dt_before_ > 0.0 ? dt_ / dt_before_ : 0.0, before = fluid_.density * grid_.cell_volume() * dt_ * 0.5 * ratio;
  for (int c = 0; c < Dim; ++c) source_impulse_[c] = -before * std::exchange(source_momentum_[c], 0.0);
}

/// s u as part of H, by the same steps in time. H is kept as -2 h times itself.
template <int Dim> void FlowSolver<Dim>::add_source_momentum(int k)
{
  const double now = dt_ * (1.0 + (dt_before_ > 0.0 ? 0.5 * dt_ / dt_before_ : 0.0));
  for (int r = 0; r < layout_.rows(); ++r)
    for (int c = 0; c < Dim; ++c) {
      const std::ptrdiff_t o = layout_.row(k, r);
      const double *source = sources_->rate() + o, *u = u_[c].data() + o;
      double *out = u_star_[c].data() + o, *kept = advection_[c].data() + o, sum = 0.0;
      for (int i = 0; i < layout_.row_length(); ++i) {
        const double brought = source[i] * u[i];
        out[i] += now * brought;
        kept[i] -= 2.0 * grid_.h * brought;
        sum += brought;
      }
      source_momentum_[c] += sum;
      source_impulse_[c] += fluid_.density * grid_.cell_volume() * now * sum;
    }
}

template <int Dim> template <Advection scheme> void FlowSolver<Dim>::predict_row(int k, int r)
{
  const double h = grid_.h, ratio = dt_before_ > 0.0 ? dt_ / dt_before_ : 0.0;
  const double now = -0.5 / h * dt_ * (1.0 + 0.5 * ratio), before = -0.5 / h * dt_ * 0.5 * ratio;
  const double gradient = 0.5 * dt_ / h, viscous = 0.5 * fluid_.kinematic_viscosity * dt_ / (h * h);
  const std::ptrdiff_t o = layout_.row(k, r);
  std::array<std::ptrdiff_t, Dim> s;
  std::array<const double *, Dim> u, face;
  std::array<double *, Dim> out, old;
  const double *p = p_.data() + o;
  Vec<Dim> push;
  for (int d = 0; d < Dim; ++d) {
    s[d] = layout_.stride(d);
    u[d] = u_[d].data() + o;
    face[d] = face_velocity_[d].data() + o;
    out[d] = u_star_[d].data() + o;
    old[d] = advection_[d].data() + o;
    push[d] = dt_ * body_force_[d];
  }
  const int n = layout_.row_length();
#pragma GCC ivdep
  for (int i = 0; i < n; ++i) {
    for (int c = 0; c < Dim; ++c) {
      const double *q = u[c] + i;
      double flux = 0.0, laplacian = -2.0 * Dim * q[0];
      for (int d = 0; d < Dim; ++d) {
        if constexpr (scheme != Advection::none)
          flux += face[d][i + s[d]] * twice_on_face<scheme>(q, s[d], face[d][i + s[d]]) - face[d][i] * twice_on_face<scheme>(q - s[d], s[d], face[d][i]);
        laplacian += q[s[d]] + q[-s[d]];
      }
      double rhs = q[0] + push[c] - gradient * (p[i + s[c]] - p[i - s[c]]) + viscous * laplacian;
      if constexpr (scheme != Advection::none) {
        rhs += now * flux - before * old[c][i];
        old[c][i] = flux;
      }
      out[c][i] = rhs;
    }
  }
}

// Between two cells, mean of G p - (G p on the face) = (p[1] - 3 p[0] + 3 p[-1] - p[-2]) / 4h, and mean of f - f on the face = (f[1] - 2 f[0] + f[-1]) / 4.
template <int Dim> void FlowSolver<Dim>::interpolate_row(int d, std::ptrdiff_t o, int first, int end)
{
  const double pressure = 0.25 * alpha_ * dt_ / grid_.h, force = 0.25 * alpha_;
  const std::ptrdiff_t s = layout_.stride(d);
  const double *u = u_star_[d].data() + o, *p = p_.data() + o;
  double *face = face_velocity_[d].data() + o;
#pragma GCC ivdep
  for (int i = first; i < end; ++i) face[i] = 0.5 * (u[i] + u[i - s]) + pressure * (p[i + s] - p[i - 2 * s] - 3.0 * (p[i] - p[i - s]));
  if (forcing_.touches_neighbourhood(plane_of(o))) {
    const double *f = forcing_.faces(d) + o;
    for (int i = first; i < end; ++i) face[i] += force * (2.0 * f[i] - f[i - s] - f[i + s]);
  }
}

template void FlowSolver<2>::factor_viscous(double);
template void FlowSolver<2>::predict_velocity(double);
template void FlowSolver<2>::predict_plane(int);
template void FlowSolver<2>::begin_source_momentum();
template void FlowSolver<2>::add_source_momentum(int);
template void FlowSolver<2>::interpolate_row(int, std::ptrdiff_t, int, int);

}  // namespace swellflow
