// The points of one object together, and their motion as a whole; free of LIGGGHTS.
#pragma once

#include <vector>

#include "vector2.h"

namespace swellflow {

/// Ring points 0 … n-1, then the hub. Positions are relative to a place near the object, so that small differences keep their digits. Per unit depth.
struct PointBody {
  std::vector<Vector2> x, v;
  std::vector<double> mass;
  std::vector<Vector2> force;    ///< of contacts, weight and all else but springs and fluid, at x
  std::vector<double> kappa;     ///< the fluid's force on a point is a - kappa v; empty in a scene without a fluid
  std::vector<Vector2> a;
  std::vector<Vector2> impulse;  ///< that a step's fluid force gave to each point; empty with kappa

  int size() const { return static_cast<int>(x.size()); }
  bool in_fluid() const { return !kappa.empty(); }
  /// Room for n points; a body is kept and used for one object after the other.
  void resize(int n, bool in_fluid);
};

/// omega e_z x r
inline Vector2 turned(double omega, const Vector2 &r) { return {-omega * r.y(), omega * r.x()}; }
inline Vector2 rotated(double cosine, double sine, const Vector2 &r)
{
  return {cosine * r.x() - sine * r.y(), sine * r.x() + cosine * r.y()};
}

/// What all points have in common.
struct WholeMotion {
  double mass = 0.0, inertia = 0.0;      ///< inertia about the centre
  Vector2 centre = Vector2::Zero(), velocity = Vector2::Zero();
  double angular_momentum = 0.0;         ///< about the centre

  double spin() const { return angular_momentum / inertia; }
};

WholeMotion whole_motion(const PointBody &body);

/// As a rigid body is accelerated.
struct RigidAcceleration {
  Vector2 linear = Vector2::Zero();
  double angular = 0.0;
  Vector2 at(const Vector2 &from_centre) const { return linear + turned(angular, from_centre); }
};

/// By the body's outer forces. `torque`: that of couples on the points, which no force shows (contact detection spheres that turn with the body).
RigidAcceleration rigid_acceleration(const PointBody &body, const WholeMotion &whole, double torque);

}  // namespace swellflow
