// What the fluid does at the sides of its box.
#pragma once

#include <vector>

#include "fluid/direct_solver.h"
#include "fluid/halo.h"
#include "fluid/side_rows.h"

namespace swellflow {

class Checkpoint;

enum class Boundary {
  wall,              ///< no-slip; its velocity lies within its plane
  slip,              ///< no flow through it, no shear on it
  periodic,
  inflow,            ///< velocity given, uniform
  parabolic_inflow,  ///< velocity given in the middle; zero at the ends of the side, times 4 s (1 - s) in each direction along it
  outflow            ///< du/dt + U_c du/dn = 0, U_c the mean velocity through all outflows; corrected so that as much leaves as enters and appears within
};

/// Side 2 d is the lower and 2 d + 1 the upper end of direction d.
template <int Dim> struct Boundaries {
  std::array<Boundary, 2 * Dim> kind{};
  std::array<Vec<Dim>, 2 * Dim> velocity{};  ///< of walls and inflows [length/time]

  std::array<bool, Dim> periodic() const;
  /// Throws std::invalid_argument with the reason when no flow can obey them.
  void require_solvable() const;
};

/// The velocity on the sides, a value a cell there, at the beginning and the end of a step; and the ghost cells that follow from it.
/// Ghosts: a given velocity is the mean of the cell and its ghost; without shear the ghost equals the cell. Pressure has no gradient at any side.
template <int Dim> class BoundaryValues {
public:
  BoundaryValues(const Grid<Dim> &grid, const Layout<Dim> &layout, const Boundaries<Dim> &boundaries);

  /// For the steps to come. Throws std::invalid_argument as Boundaries::require_solvable.
  void set_velocity(int side, const Vec<Dim> &velocity);
  /// At the start: the velocity on outflows is that of the cells there.
  void start(const VectorField<Dim> &u);
  bool has_outflow() const { return outflow_area_ > 0.0; }
  /// The velocities at the end of a step of length dt, with sources within the box as they were. Collective where there is an outflow.
  void advance(double dt, const VectorField<Dim> &u);
  /// Outflows take what appears within the box [length^Dim / time] from now on, this step included: all normal velocities there change by the same.
  void let_out(double source);
  /// What was the end is the beginning of the next step.
  void end_step() { present_ = next_; }
  /// Between two steps. Collective.
  void keep(Checkpoint &file);

  AllEnds<Dim> velocity_ends(int component) const;
  AllEnds<Dim> pressure_ends() const;

  /// Ghosts of the velocity at the beginning of the step, those of other ranks too; with width 2 the second ghost continues the first in a line. Collective.
  void fill_velocity(VectorField<Dim> &u, int width, const Halo<Dim> &halo) const;
  /// Ghosts within own plane k of a field without gradient at the sides; `width` of them where periodic.
  void fill_scalar_plane(Field<Dim> &field, int k, int width, const Halo<Dim> &halo) const;
  /// The ghost planes of such a field, after all of its own planes. Collective.
  void fill_scalar_ends(Field<Dim> &field, int width, const Halo<Dim> &halo) const;

  /// Adds factor times the velocity at the end of the step to the cells of plane k at sides where component c is given.
  void add_given(int c, int k, double factor, Field<Dim> &rhs) const;
  /// The normal velocities on the sides at the end of the step.
  void set_faces(VectorField<Dim> &faces) const;

private:
  template <int> friend class SideImpulses;
  using SideValues = std::array<std::vector<double>, Dim>;

  bool is_given(int side, int c) const;
  bool is_here(int side) const { return boundaries_.kind[side] != Boundary::periodic && rows_.reach(side); }
  template <class F> void each_row(int side, F &&f) const
  {
    if (is_here(side)) rows_.each(side, f);
  }
  double profile(int side, std::size_t index) const;
  void set_given(int side);
  void carry_out(double dt, const VectorField<Dim> &u);
  double entering() const;
  void shift_outflows(double change);

  const Grid<Dim> &grid_;
  const Layout<Dim> &layout_;
  SideRows<Dim> rows_;
  Boundaries<Dim> boundaries_;
  std::array<SideValues, 2 * Dim> present_, next_;
  double outflow_area_ = 0.0, source_ = 0.0;
};

extern template struct Boundaries<2>;
extern template class BoundaryValues<2>;

}  // namespace swellflow
