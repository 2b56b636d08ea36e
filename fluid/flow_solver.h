// The flow solver: incompressible Navier-Stokes on a collocated grid, implicit viscosity, exact projection.
#pragma once

#include <memory>

#include "fluid/direct_solver.h"
#include "fluid/face_forcing.h"

namespace swellflow {

struct FluidProperties {
  double density;              ///< mass / volume
  double kinematic_viscosity;  ///< length^2 / time
};

/// Velocity of the wall at each side, side 2 d being the lower and 2 d + 1 the upper end of direction d. Normal components must be zero.
template <int Dim> using WallVelocities = std::array<Vec<Dim>, 2 * Dim>;

/// SMAC on a uniform collocated grid (Ushijima et al., J. JSCE 75, 2019): velocity u and pressure p in the cells, face velocities F that the
/// projection makes divergence-free and that carry the advection. One step of length dt:
///
///   (1 - dt nu/2 L) u~ = u + dt [ (1 + r/2) H^n - r/2 H^(n-1) - G p + nu/2 L u ] + mean of f on the two faces,      H = -div(F u), r = dt / dt_before
///   F~ = mean of u~ in the two cells + alpha { dt [ mean of G p - (G p on the face) ] - [ mean of f - (f on the face) ] },     alpha = 1 / (1 + 4 nu dt / h^2)
///   (markers change u~ and F~)
///   div G phi = div F~ / dt,     F = F~ - dt G phi,     u = u~ - dt G phi,     p = p + phi
///
/// Advection is Adams-Bashforth (Euler in the first step), viscosity Crank-Nicolson: second order in h and dt without markers.
/// f is a change of velocity, already multiplied by dt. p here is pressure / density.
template <int Dim> class FlowSolver {
public:
  /// Throws std::invalid_argument on a wall that moves along its normal. Collective.
  FlowSolver(const Grid<Dim> &grid, const FluidProperties &fluid, const WallVelocities<Dim> &walls);

  /// u~ and F~ from the last step, with the forcing as it stands taken as part of the right-hand side. Collective.
  void predict_velocity(double dt);
  /// Adds the forcing as it stands to u~ and F~. Collective only through FaceForcing::complete before it.
  void apply_forcing();
  /// Makes F divergence-free and ends the step. Collective.
  void project(double dt);

  FaceForcing<Dim> &forcing() { return forcing_; }
  const FaceForcing<Dim> &forcing() const { return forcing_; }
  /// F, the normal velocities on the faces of this rank's cells.
  const VectorField<Dim> &face_velocity() const { return face_velocity_; }
  /// The same with the ghost planes that markers near the slab's ends reach into. Collective.
  const VectorField<Dim> &face_velocity_around()
  {
    for (int c = 0; c < Dim; ++c) halo_.fill(face_velocity_[c], Grid<Dim>::ghost);
    return face_velocity_;
  }
  const VectorField<Dim> &velocity() const { return u_; }
  const Field<Dim> &pressure_over_density() const { return p_; }

  const Grid<Dim> &grid() const { return grid_; }
  const Layout<Dim> &layout() const { return layout_; }
  const FluidProperties &fluid() const { return fluid_; }

  double largest_divergence_here() const;  ///< on this rank
  /// Over all cells of all ranks. Collective.
  double max_divergence() const { return largest_over_ranks(largest_divergence_here()); }
  double max_speed_sum() const;  ///< max over cells of sum_d |u_d|: times dt / h this is the CFL number
  double kinetic_energy() const;

  /// Sets the velocity of a cell of this rank (for tests and initial states), then `start_from_velocity` on all ranks.
  VectorField<Dim> &initial_velocity() { return u_; }
  void start_from_velocity();

private:
  void fill_velocity_ghosts();
  void fill_gradient_ghosts(Field<Dim> &field, int halo_width);
  void predict_plane(int k);
  void add_wall_motion(int c, int k);
  void interpolate_to_faces();
  void divergence_plane(int k, double *out, double scale) const;
  void correct(double dt);
  /// f(d, offset, i_begin, i_end) for each row of faces between two cells, those at the upper end of this rank's slab included.
  template <class F> void each_face_row(F &&f) const;
  template <class F> void each_cell(F &&f) const;  ///< f(offset), own cells
  double largest_over_ranks(double value) const;

  Grid<Dim> grid_;
  Layout<Dim> layout_;
  Halo<Dim> halo_;
  FluidProperties fluid_;
  WallVelocities<Dim> walls_;
  VectorField<Dim> u_, u_star_, face_velocity_, advection_;
  Field<Dim> p_, phi_;
  FaceForcing<Dim> forcing_;
  DirectSolver<Dim> viscous_, poisson_;
  double dt_ = 0.0, dt_before_ = 0.0, dt_factored_ = 0.0, alpha_ = 1.0;
};

extern template class FlowSolver<2>;

}  // namespace swellflow
