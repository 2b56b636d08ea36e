// One implicit time step of the points of an object under its springs, dashpots and the fluid's drag law; free of LIGGGHTS.
#pragma once

#include <vector>

#include "point_body.h"
#include "ring_solver.h"
#include "spring_set.h"

namespace swellflow {

/// What a step does to the energy of vibrations.
enum class SpringEnergy {
  dissipate,  ///< backward Euler: those faster than the step die out, of slower ones a share of order omega dt a radian
  conserve    ///< discrete gradient (LaBudde and Greenspan 1976, Gonzalez 1996): kinetic + spring energy is kept at any step
};

/// Solves, with theta = 1 (dissipate) or 1/2 (conserve),
///     m (v1 - v0) = dt (F(x0, x1) + g + a - kappa v1),   x1 = x0 + dt ((1 - theta) v0 + theta v1)
/// by Newton's method, with one direct solution over the whole object an iteration; F are the springs and dashpots, g outer forces that squeeze and stretch the object but
/// do not move it as a whole. Nothing limits dt by the springs: as k grows without bound the motion becomes that of the rigid body.
///
/// After the solution the object has exactly the momentum and angular momentum that it had, plus what the fluid gave; and it has turned by dt times its spin, which
/// the chords of a circle fall short of.
class ImplicitSprings {
public:
  explicit ImplicitSprings(SpringEnergy energy) : energy_(energy), theta_(energy == SpringEnergy::dissipate ? 1.0 : 0.5) {}

  /// Moves body.x and body.v over dt, and adds the fluid's impulse to body.impulse. `g` [force]: one a point, without a sum and without a torque. False when
  /// Newton's method failed, also in ever smaller parts of the step; the body is spoilt then.
  bool advance(PointBody &body, const SpringSet &springs, const std::vector<Vector2> &g, double dt);
  SpringEnergy energy() const { return energy_; }
  /// Of all steps so far.
  long newton_iterations() const { return iterations_; }

private:
  bool solve(PointBody &body, const SpringSet &springs, const std::vector<Vector2> &g, double dt);
  void guess(const PointBody &body, const SpringSet &springs, const std::vector<Vector2> &g, double dt, const WholeMotion &before);
  bool iterate(const PointBody &body, const SpringSet &springs, const std::vector<Vector2> &g, double dt);
  void assemble(const PointBody &body, const SpringSet &springs, const std::vector<Vector2> &g, double dt, bool clamped);
  void add_spring(int a, int b, const Spring &spring, double dt, bool clamped);
  double go_downhill(const PointBody &body, const SpringSet &springs, const std::vector<Vector2> &g, double dt, double change);
  double potential(const PointBody &body, const SpringSet &springs, const std::vector<Vector2> &g, double dt, const std::vector<Vector2> &x) const;
  double largest_change(int n) const;
  void restore_momentum(PointBody &body, double dt, const WholeMotion &before);
  void turn_by_spin(PointBody &body, double dt, const WholeMotion &before);

  SpringEnergy energy_;
  double theta_;
  long iterations_ = 0;
  RingSolver system_;
  std::vector<Vector2> x0_, v0_, x1_, trial_;  // of the present part of the step
  std::vector<Vector2> x_, v_, impulse_;     // when the step began
};

}  // namespace swellflow
