// What the fluid in a narrow gap between two discs does to them, and how much of it a grid leaves out; free of LIGGGHTS.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

namespace swellflow {

/// 1 / R* = 1 / R1 + 1 / R2. A wall has no curvature: R* = R.
inline double effective_radius(double R1, double R2) { return R1 * R2 / (R1 + R2); }

/// Force over speed of approach, per unit depth, in the gap of two parabolas: 3 sqrt(2) pi mu (R* / gap)^1.5 (Reynolds' equation; for a cylinder and a wall the limit of
/// Jeffrey & Onishi, Q. J. Mech. Appl. Math. 34, 129, 1981, 4 pi mu / (alpha - tanh alpha), cosh alpha = 1 + gap / R).
inline double lubrication_resistance(double viscosity, double radius, double gap)
{
  return 3.0 * std::numbers::sqrt2 * std::numbers::pi * viscosity * std::pow(radius / gap, 1.5);
}

/// The part that a grid does not resolve: nothing from a cutoff on; from `minimum` down it grows no more (roughness). Two discs have a cutoff of their own, since each
/// is half as near to the plane midway as to a wall.
struct LubricationLaw {
  double viscosity = 0.0, wall_cutoff = 0.0, pair_cutoff = 0.0, minimum = 0.0;

  double missing_at_wall(double R, double gap) const { return missing(R, gap, wall_cutoff); }
  double missing_between(double R1, double R2, double gap) const { return missing(effective_radius(R1, R2), gap, pair_cutoff); }
  /// At a side without friction, which is the plane midway between the disc and its mirror image: that comes as fast, from twice the gap.
  double missing_at_mirror(double R, double gap) const { return 2.0 * missing_between(R, R, 2.0 * gap); }

private:
  double missing(double radius, double gap, double cutoff) const
  {
    if (gap >= cutoff) return 0.0;
    return lubrication_resistance(viscosity, radius, std::max(gap, minimum)) - lubrication_resistance(viscosity, radius, cutoff);
  }
};

/// Force over the speed at the start of a step, so that the step is one of Euler backward: m1 dv1 = -m2 dv2 = -dt c (v1 - v2) at its end. `share1`: the inverse of the part
/// of its mass that body 1 has for this gap. With the mass shared out equally over a body's gaps its velocity is the mean of those that its parts get, and by Jensen's
/// inequality kinetic energy never grows, for any step and any number of gaps.
inline double implicit_resistance(double resistance, double dt, double share1, double share2)
{
  return resistance / (1.0 + resistance * dt * (share1 + share2));
}

}  // namespace swellflow
