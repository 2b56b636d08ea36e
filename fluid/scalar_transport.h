// A quantity that the flow carries along and that diffuses: dissolved matter, a share of fresh water, heat.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "fluid/direct_solver.h"
#include "fluid/halo.h"
#include "fluid/side_rows.h"

namespace swellflow {

class Checkpoint;

/// What a scalar does at a side of the box.
enum class ScalarSide {
  open,   ///< nothing diffuses through; what flows in has the value of the cell that it comes to. At a periodic side that is not cut: nothing ends there
  feed,   ///< nothing diffuses through; what flows in has the value given
  value   ///< the value given holds on the side: what flows in has it, and it diffuses
};

/// c in the cells of a grid,  dc/dt + div(F c) = D L c,  F the velocities on the faces, the mean of those at the beginning and the end of a step. A step of length dt:
///
///   c <- c + (1 - theta) dt D L c
///   c <- advection over dt: Heun's method, with the values on faces that van Leer's limiter gives (advection.h), in steps so short that sum over faces |F| dt / h <= 1 in each cell
///   c <- c + theta dt D L c, with the c of the end; where D dt is small, the first terms of that solution's series in D dt
///
/// theta = 1/2 as long as the explicit part makes no new extrema, z w <= 2 with z = D dt / h^2 and w the sum of the stencil's weights, 2 Dim away from sides: then each step is the mirror image
/// of itself in time, and of order 2. Beyond, theta = 1 - 1 / (z w): no method of second order makes none at any dt (Bolley & Crouzeix, RAIRO Anal. Num. 12, 1978). Each stage gives a
/// cell a mean of old values with weights >= 0: no new extrema, but for round-off. Shown for advection in docs/theory.md.
///
/// Sums of c change by what goes through the sides alone, to round-off; where F diverges (CellSources) what appears has the value of its cell.
///
/// A periodic direction one of whose sides is not `open` is cut: what leaves is gone, what enters has the value given, or, at the side that is open, that of the cell; nothing diffuses across.
template <int Dim> class ScalarTransport {
public:
  using Sides = std::array<ScalarSide, 2 * Dim>;

  /// diffusivity >= 0 [length^2 / time]. The values on sides are 0 until they are set. Collective.
  ScalarTransport(const Grid<Dim> &grid, const Layout<Dim> &layout, double diffusivity, const Sides &sides);

  /// For the steps to come.
  void set_side_value(int side, double value) { side_value_[side] = value; }

  /// c; before the first step it may be written.
  Field<Dim> &values() { return c_; }
  const Field<Dim> &values() const { return c_; }
  /// The same with the ghosts that markers near the slab's ends and periodic sides reach into, also across sides that are cut. Collective.
  const Field<Dim> &values_around();

  /// faces: F at the end of the step. `grows`: it may diverge. Collective.
  void advance(double dt, const VectorField<Dim> &faces, bool grows);
  int sub_steps() const { return sub_steps_; }  ///< of advection in the last step

  /// A field to be filled, zero: amounts by which c in a cell is to shrink, relative to what is left of it. Ghosts are added to the cells that they stand for.
  Field<Dim> &withdrawal();
  /// c <- c / (1 + withdrawal): never below zero. Collective.
  void withdraw();

  /// This rank's part of what went where since c was made, amounts [c length^Dim].
  struct Budget {
    double entered = 0.0, left = 0.0;  ///< through the sides
    double appeared = 0.0;             ///< where F diverges
    double withdrawn = 0.0;
  };
  const Budget &budget() const { return budget_; }
  double total_here() const;
  struct Extremes {
    double smallest, largest;
  };
  Extremes extremes_here() const;
  /// Its state between two steps goes into a checkpoint, or comes from it, under this name. Collective.
  void keep(Checkpoint &file, const std::string &name);

private:
  bool is_cut(int d) const { return sides_[2 * d] != ScalarSide::open || sides_[2 * d + 1] != ScalarSide::open; }
  /// Whether the scalar ends at a side, rather than going on at the other end.
  bool ends_at(int side) const { return !grid_.periodic[side / 2] || is_cut(side / 2); }

  void take_mean_of_faces(const VectorField<Dim> &faces);
  int sub_steps_for(double dt) const;
  template <bool grows> void advect(double dt);
  template <bool grows> void carry(const Field<Dim> &from, double dt);
  template <bool grows, bool last> void carry_row(const double *from, double *to, std::ptrdiff_t o, double step);
  void fill_carried_ghosts(Field<Dim> &field);
  void count_carried(const Field<Dim> &field, double dt);

  // scalar_diffusion.cpp
  AllEnds<Dim> ends() const;
  double stencil_weight() const;
  void diffuse_explicitly(double z);
  void diffuse_by_series(double z);
  void diffuse_implicitly(double z);
  void fill_diffusing_ghosts(Field<Dim> &field);
  void difference_plane(int k, double z, const Field<Dim> &from, const Field<Dim> *onto, Field<Dim> &to);
  void add_plane(int k);
  void count_diffused(const Field<Dim> &field, double z);

  template <class F> void each_row(F &&f) const;  ///< f(offset), own rows

  const Grid<Dim> &grid_;
  const Layout<Dim> &layout_;
  Halo<Dim> halo_;
  SideRows<Dim> rows_;
  double diffusivity_;
  Sides sides_;
  std::array<double, 2 * Dim> side_value_{};
  Field<Dim> c_, change_;      // change_: between two stages of a step, and what is withdrawn
  VectorField<Dim> carrier_;   // F of the step under way; after it F at its end
  bool knows_faces_before_ = false;
  std::shared_ptr<DirectSolver<Dim>> solver_;
  std::optional<JointSolve<Dim, 1>> solve_;
  double z_factored_ = -1.0;
  int sub_steps_ = 0;
  Budget budget_;
};

extern template class ScalarTransport<2>;

}  // namespace swellflow
