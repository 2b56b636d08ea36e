// The flow solver: incompressible Navier-Stokes on a collocated grid, implicit viscosity, exact projection.
#pragma once

#include <memory>
#include <optional>

#include "fluid/advection.h"
#include "fluid/boundaries.h"
#include "fluid/cell_sources.h"
#include "fluid/direct_solver.h"
#include "fluid/face_forcing.h"
#include "fluid/phase_clock.h"
#include "fluid/side_impulses.h"

namespace swellflow {

struct FluidProperties {
  double density;              ///< mass / volume
  double kinematic_viscosity;  ///< length^2 / time
};

/// SMAC on a uniform collocated grid (Ushijima et al., J. JSCE 75, 2019): velocity u and pressure p in the cells, face velocities F that the
/// projection makes divergence-free and that carry the advection. One step of length dt:
///
///   (1 - dt nu/2 L) u~ = u + dt [ (1 + r/2) H^n - r/2 H^(n-1) - G p + nu/2 L u + g ] + mean of f on the two faces,      H = -div(F u), r = dt / dt_before
///   F~ = mean of u~ in the two cells + alpha { dt [ mean of G p - (G p on the face) ] - [ mean of f - (f on the face) ] },     alpha = 1 / (1 + 4 nu dt / h^2)
///   (markers change u~ and F~)
///   div G phi = (div F~ - s) / dt,     F = F~ - dt G phi,     u = u~ - dt G phi,     p = p + phi
///
/// Advection is Adams-Bashforth (Euler in the first step), viscosity Crank-Nicolson: second order in h and dt without markers. f is a change of velocity,
/// already multiplied by dt. p here is pressure / density. g is the body force per mass, felt in periodic directions: in others it would only make a pressure
/// that grows along it, which is left out as that of gravity is. s are the sources: what they bring has the velocity of the fluid there, so that H has + s u as well.
///
/// Planes are worked on in the order of the direct solves, while they are in cache: the right-hand side of a plane is written just before its transform, face velocities and
/// the projection's corrections follow the solution by one plane.
template <int Dim> class FlowSolver {
public:
  /// Throws std::invalid_argument on boundaries that no flow can obey. Collective.
  FlowSolver(const Grid<Dim> &grid, const FluidProperties &fluid, const Boundaries<Dim> &boundaries, Advection advection = Advection::central);

  /// For the steps to come: the velocity of a wall or an inflow at the end of a step, the body force per mass during it.
  void set_side_velocity(int side, const Vec<Dim> &velocity) { sides_.set_velocity(side, velocity); }
  void set_body_force(const Vec<Dim> &g);
  /// What of it is felt: 0 in directions that are not periodic.
  const Vec<Dim> &body_force() const { return body_force_; }

  /// u~ and F~ from the last step, with the forcing as it stands taken as part of the right-hand side. Collective.
  void predict_velocity(double dt);
  /// Adds the forcing as it stands to u~ and F~. Collective only through FaceForcing::complete before it.
  void apply_forcing();
  /// Where fluid appears within the box during the step, cleared and filled before `project`: div F is that, and outflows let it out. Throws std::invalid_argument in a box without
  /// outflow.
  CellSources<Dim> &sources();
  bool has_sources() const { return sources_.has_value(); }
  /// Makes F divergence-free, or div F the sources, and ends the step. Collective.
  void project(double dt);
  /// The same to u~ and F~ before markers change them, so that they meet a fluid with the pressure of their new places; the step goes on. Collective.
  void project_prediction(double dt) { make_divergence_free(dt); }

  FaceForcing<Dim> &forcing() { return forcing_; }
  const FaceForcing<Dim> &forcing() const { return forcing_; }
  /// F, the normal velocities on the faces of this rank's cells.
  const VectorField<Dim> &face_velocity() const { return face_velocity_; }
  /// The same with the ghosts that markers near the slab's ends and periodic sides reach into. Collective.
  const VectorField<Dim> &face_velocity_around();
  const VectorField<Dim> &velocity() const { return u_; }
  const Field<Dim> &pressure_over_density() const { return p_; }

  const Grid<Dim> &grid() const { return grid_; }
  const Layout<Dim> &layout() const { return layout_; }
  const FluidProperties &fluid() const { return fluid_; }
  const PhaseClock &clock() const { return clock_; }

  double largest_divergence_here() const;  ///< on this rank, less the sources
  /// Over all cells of all ranks. Collective.
  double max_divergence() const;
  double max_speed_sum() const;  ///< max over cells of sum_d |u_d|: times dt / h this is the CFL number
  double kinetic_energy() const;
  Vec<Dim> mean_velocity() const;
  /// What the fluid received through each side in the last step: this rank's part.
  const typename SideImpulses<Dim>::BySide &side_impulses_here() const { return side_impulses_.here(); }
  /// Volume that leaves through the sides less what enters, per time: this rank's part.
  double outflow_here() const { return side_impulses_.outflow_here(); }
  /// What came with the sources: this rank's part.
  const Vec<Dim> &source_impulse_here() const { return source_impulse_; }

  /// Sets the velocity of a cell of this rank (for tests and initial states), then `start_from_velocity` on all ranks.
  VectorField<Dim> &initial_velocity() { return u_; }
  void start_from_velocity();
  /// The same everywhere.
  void start_with_velocity(const Vec<Dim> &velocity);
  /// Its state between two steps goes into a checkpoint, or comes from it. Collective.
  void keep(Checkpoint &file);

private:
  using Solver = std::shared_ptr<DirectSolver<Dim>>;

  std::array<Solver, Dim> viscous_solvers() const;
  void factor_viscous(double dt);
  void predict_plane(int k);
  template <Advection scheme> void predict_row(int k, int r);
  bool own(int plane) const { return plane >= 0 && plane < layout_.planes(); }
  /// f(d, offset, first, end) for the rows of faces within plane k that lie between two cells; `end` counts from the row's first cell.
  template <class F> void each_face_row_in_plane(int k, F &&f) const;
  template <class F> void each_face_row_below_plane(int k, F &&f) const;  ///< the same for faces between plane k - 1 and k
  template <class F> void each_face_row(F &&f) const;
  /// Whether there are cells on both sides of the faces below plane k.
  bool inner_faces(int k) const { return (k > 0 || !grid_.at_lower_end()) && (k < layout_.planes() || !grid_.at_upper_end()); }
  int plane_of(std::ptrdiff_t offset) const { return static_cast<int>((offset - layout_.row(0, 0)) / layout_.plane_stride()); }
  void add_forcing_to_cells(int k);
  void begin_source_momentum();
  void add_source_momentum(int k);
  void interpolate_row(int d, std::ptrdiff_t o, int first, int end);
  void correct_face_row(int d, std::ptrdiff_t o, int first, int end);
  void make_divergence_free(double dt);
  void divergence_plane(int k);
  void correct_plane(int k);
  template <class F> void each_cell(F &&f) const;  ///< f(offset), own cells

  Grid<Dim> grid_;
  Layout<Dim> layout_;
  Halo<Dim> halo_;
  FluidProperties fluid_;
  BoundaryValues<Dim> sides_;
  SideImpulses<Dim> side_impulses_;
  Advection advection_scheme_;
  VectorField<Dim> u_, u_star_, face_velocity_, advection_;
  Field<Dim> p_, phi_;
  FaceForcing<Dim> forcing_;
  std::optional<CellSources<Dim>> sources_;
  std::array<Solver, Dim> viscous_;
  Solver poisson_;
  JointSolve<Dim, Dim> solve_viscous_;
  JointSolve<Dim, 1> solve_poisson_;
  Vec<Dim> body_force_{}, source_impulse_{}, source_momentum_{};  // source_momentum_: sum of s u over the cells when the last step began
  double dt_ = 0.0, dt_before_ = 0.0, dt_factored_ = -1.0, alpha_ = 1.0;
  PhaseClock clock_;
};

extern template class FlowSolver<2>;

}  // namespace swellflow
