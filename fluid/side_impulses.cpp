#include "fluid/side_impulses.h"

namespace swellflow {

/// Whether anything flows through it.
template <int Dim> bool SideImpulses<Dim>::is_open(int side) const
{
  const Boundary kind = sides_.boundaries_.kind[side];
  return kind != Boundary::wall && kind != Boundary::slip && kind != Boundary::periodic;
}

template <int Dim> template <Advection scheme> Vec<Dim> SideImpulses<Dim>::carried(int side, const VectorField<Dim> &u, const VectorField<Dim> &faces) const
{
  Vec<Dim> sum{};
  if (scheme == Advection::none || !is_open(side)) return sum;
  const int d = side / 2;
  const bool upper = side % 2;
  const std::ptrdiff_t s = layout_.stride(d), face = upper ? s : 0, below = upper ? 0 : -s;
  sides_.each_row(side, [&](std::size_t, std::ptrdiff_t cell, int n) {
    for (int i = 0; i < n; ++i) {
      const double F = faces[d][cell + face + i];
      for (int c = 0; c < Dim; ++c) sum[c] += 0.5 * F * twice_on_face<scheme>(u[c].data() + cell + below + i, s, F);
    }
  });
  if (!upper)
    for (double &component : sum) component = -component;
  return sum;
}

template <int Dim> void SideImpulses<Dim>::begin_step(double dt, double dt_before, const VectorField<Dim> &u, const VectorField<Dim> &faces)
{
  dt_ = dt;
  const double ratio = dt_before > 0.0 ? dt / dt_before : 0.0, per_flux = density_ * grid_.cell_volume() / grid_.h * dt;
  const double per_difference = 0.5 * viscosity_ / grid_.h * per_flux;
  for (int side = 0; side < 2 * Dim; ++side) {
    Vec<Dim> now{}, difference{};
    switch (scheme_) {
      case Advection::central: now = carried<Advection::central>(side, u, faces); break;
      case Advection::bounded: now = carried<Advection::bounded>(side, u, faces); break;
      case Advection::none: break;
    }
    const std::ptrdiff_t out = sides_.rows_.outwards(side);
    sides_.each_row(side, [&](std::size_t, std::ptrdiff_t cell, int n) {
      for (int c = 0; c < Dim; ++c)
        for (int i = 0; i < n; ++i) difference[c] += u[c][cell + out + i] - u[c][cell + i];
    });
    for (int c = 0; c < Dim; ++c)
      impulse_[side][c] = per_difference * difference[c] - per_flux * ((1.0 + 0.5 * ratio) * now[c] - 0.5 * ratio * carried_[side][c]);
    carried_[side] = now;
  }
}

template <int Dim> void SideImpulses<Dim>::add_implicit_viscosity(const VectorField<Dim> &u_star)
{
  const double per_difference = 0.5 * viscosity_ * density_ * grid_.cell_volume() / (grid_.h * grid_.h) * dt_;
  for (int side = 0; side < 2 * Dim; ++side) {
    Vec<Dim> difference{};
    sides_.each_row(side, [&](std::size_t first, std::ptrdiff_t cell, int n) {
      for (int c = 0; c < Dim; ++c) {
        const double *given = sides_.next_[side][c].data() + first, *u = u_star[c].data() + cell;
        for (int i = 0; i < n; ++i) difference[c] += 2.0 * (given[i] - u[i]);
      }
    });
    for (int c = 0; c < Dim; ++c)
      if (sides_.is_given(side, c)) impulse_[side][c] += per_difference * difference[c];
  }
}

template <int Dim> void SideImpulses<Dim>::end_step(const Field<Dim> &p, const VectorField<Dim> &faces)
{
  const double area = grid_.cell_volume() / grid_.h;
  outflow_ = 0.0;
  for (int side = 0; side < 2 * Dim; ++side) {
    const int d = side / 2;
    const std::ptrdiff_t face = sides_.rows_.face(side);
    double pressure = 0.0, flow = 0.0;
    sides_.each_row(side, [&](std::size_t, std::ptrdiff_t cell, int n) {
      for (int i = 0; i < n; ++i) pressure += p[cell + i];
      if (is_open(side))
        for (int i = 0; i < n; ++i) flow += faces[d][cell + face + i];
    });
    const double outwards = side % 2 ? area : -area;
    impulse_[side][d] -= density_ * dt_ * outwards * pressure;
    outflow_ += outwards * flow;
  }
}

template class SideImpulses<2>;

}  // namespace swellflow
