// The impulses that the fluid receives through the sides of its box.
#pragma once

#include "fluid/advection.h"
#include "fluid/boundaries.h"

namespace swellflow {

/// The fluxes of the scheme itself, summed over the cells along each side [mass length / time; 2-D: per unit depth]:
///
///   pressure    -dt p_new n, p that of the cell, as it has no gradient across a side
///   viscosity   nu dt / 2 [ (ghost - cell) of u, as the step begins, + (ghost - cell) of u~ ] / h
///   advection   -dt [ (1 + r/2) F u^n - (r/2) F u^(n-1) ] through the side
///
/// What cells exchange among each other cancels, so that the momentum of all cells changes in a step by these, what markers give and the body force: to round-off.
template <int Dim> class SideImpulses {
public:
  using BySide = std::array<Vec<Dim>, 2 * Dim>;

  SideImpulses(const BoundaryValues<Dim> &sides, const Grid<Dim> &grid, const Layout<Dim> &layout, double density, double viscosity, Advection scheme)
      : sides_(sides), grid_(grid), layout_(layout), density_(density), viscosity_(viscosity), scheme_(scheme)
  {
  }

  /// A new step: what follows from u, its ghosts included, and the face velocities as they are when it begins.
  void begin_step(double dt, double dt_before, const VectorField<Dim> &u, const VectorField<Dim> &faces);
  /// The implicit half of viscosity, from the solution u~.
  void add_implicit_viscosity(const VectorField<Dim> &u_star);
  /// Pressure, and what flows through the sides as the step ends.
  void end_step(const Field<Dim> &p, const VectorField<Dim> &faces);
  void keep(Checkpoint &file);  ///< collective

  /// This rank's part.
  const BySide &here() const { return impulse_; }
  /// Volume that leaves through all sides less what enters [length^Dim / time], this rank's part.
  double outflow_here() const { return outflow_; }

private:
  bool is_open(int side) const;
  template <Advection scheme> Vec<Dim> carried(int side, const VectorField<Dim> &u, const VectorField<Dim> &faces) const;

  const BoundaryValues<Dim> &sides_;
  const Grid<Dim> &grid_;
  const Layout<Dim> &layout_;
  double density_, viscosity_, dt_ = 0.0, outflow_ = 0.0;
  Advection scheme_;
  BySide impulse_{}, carried_{};  // carried_: F u leaving through the side [velocity^2], summed over its cells, when the last step began
};

extern template class SideImpulses<2>;

}  // namespace swellflow
