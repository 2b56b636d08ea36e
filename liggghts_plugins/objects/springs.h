// Springs and dashpots between the points of an object; free of LIGGGHTS.
#pragma once

#include <cmath>
#include <numbers>

#include "vector2.h"

namespace swellflow {

/// zeta of a damped oscillator whose speed after half a period is e times the speed before it.
inline double damping_ratio(double restitution)
{
  const double ln_e = std::abs(std::log(restitution));
  return ln_e / std::sqrt(std::numbers::pi * std::numbers::pi + ln_e * ln_e);
}

/// c = 2 zeta sqrt(m k), m the reduced mass of the pair. Eq. (4) of Guinea, Toriu and Ushijima (2022) has one point's mass there, which gives the asked restitution
/// only for a point on a fixed anchor.
inline double dashpot_constant(double damping_ratio, double stiffness, double mass_a, double mass_b)
{
  return 2.0 * damping_ratio * std::sqrt(stiffness * mass_a * mass_b / (mass_a + mass_b));
}

/// From B to A. Two points on one spot have no direction between them, and no force.
struct Direction {
  double distance;
  Vector2 n;

  Direction(const Vector2 &X_A, const Vector2 &X_B) : distance((X_A - X_B).norm()), n((distance > 0.0 ? 1.0 / distance : 0.0) * (X_A - X_B)) {}
};

/// Force on A of a spring A-B of natural length L: -k (xi - L) n, the first term of eq. (3) of the paper.
inline Vector2 spring_force(const Direction &along, double L, double k) { return -k * (along.distance - L) * along.n; }

/// Force on A of a dashpot along A-B: -c ((U_A - U_B).n) n. The second term of eq. (3) has the other sign, which would feed
/// energy, and is not projected on the spring, which would brake rotation.
inline Vector2 dashpot_force(const Direction &along, const Vector2 &U_A_less_U_B, double c) { return -c * U_A_less_U_B.dot(along.n) * along.n; }

}  // namespace swellflow
