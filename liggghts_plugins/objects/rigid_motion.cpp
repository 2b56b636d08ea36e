#include "rigid_motion.h"

#include <Eigen/Dense>
#include <cmath>

#include "orientation.h"

namespace swellflow {

namespace {

/// Of the size, in a step. What is more is no growth but another shape put right: points are then placed without a velocity.
constexpr double largest_growth = 0.01;

/// How `rest` must be turned and stretched to come nearest to a body.
struct Fit {
  Vector2 rest_centre = Vector2::Zero();
  double rest_inertia = 0.0;
  BestFit turn;

  Fit(const PointBody &body, const WholeMotion &whole, const std::vector<Vector2> &rest)
  {
    for (int i = 0; i < body.size(); ++i) rest_centre += body.mass[i] / whole.mass * rest[i];
    for (int i = 0; i < body.size(); ++i) {
      const Vector2 y = rest[i] - rest_centre;
      rest_inertia += body.mass[i] * y.squaredNorm();
      turn.add(y, body.x[i] - whole.centre, body.mass[i]);
    }
  }
  double size() const { return std::hypot(turn.crossed, turn.along) / rest_inertia; }
};

/// Takes a rigid motion (V, w) to the velocity of a point at r from the centre.
Eigen::Matrix<double, 2, 3> motion_at(const Vector2 &r)
{
  Eigen::Matrix<double, 2, 3> motion;
  motion << 1.0, 0.0, -r.y(), 0.0, 1.0, r.x();
  return motion;
}

Eigen::Vector3d motion_of(const WholeMotion &whole) { return {whole.velocity.x(), whole.velocity.y(), whole.spin()}; }

/// Velocity and spin (about the centre) after the fluid's impulse: m (V1 - V) = dt sum (a - kappa u), I (w1 - w) = dt sum r x (a - kappa u), u = V1 + w1 x r + growth r.
Eigen::Vector3d motion_after_drag(const PointBody &body, const WholeMotion &whole, double growth, double dt)
{
  Eigen::Matrix3d A = Eigen::Vector3d(whole.mass, whole.mass, whole.inertia).asDiagonal();
  Eigen::Vector3d b = A * motion_of(whole);
  for (int i = 0; i < body.size(); ++i) {
    const Vector2 r = body.x[i] - whole.centre;
    const Eigen::Matrix<double, 2, 3> motion = motion_at(r);
    A += dt * body.kappa[i] * motion.transpose() * motion;
    b += motion.transpose() * (dt * (body.a[i] - body.kappa[i] * growth * r));
  }
  return A.ldlt().solve(b);
}

/// The same, and each point gets its impulse. What the points are said to have received is what the body has received, to the last digit.
Eigen::Vector3d feel_drag(PointBody &body, const WholeMotion &whole, double growth, double dt)
{
  const Eigen::Vector3d motion = motion_after_drag(body, whole, growth, dt);
  Eigen::Vector3d result = motion_of(whole);
  for (int i = 0; i < body.size(); ++i) {
    const Vector2 r = body.x[i] - whole.centre, impulse = dt * (body.a[i] - body.kappa[i] * (motion_at(r) * motion + growth * r));
    body.impulse[i] += impulse;
    result += Eigen::Vector3d(impulse.x() / whole.mass, impulse.y() / whole.mass, cross(r, impulse) / whole.inertia);
  }
  return result;
}

/// Points that turn move along the chord, spin x r - spin^2 dt/2 r: what the drag over the whole step has to do with, as that of points that are moved one by one.
double chord_rate(const WholeMotion &whole, double dt) { return -0.5 * dt * whole.spin() * whole.spin(); }

}  // namespace

RigidAcceleration drag_as_a_whole(const PointBody &body, const WholeMotion &whole, double dt)
{
  const Eigen::Vector3d change = motion_after_drag(body, whole, chord_rate(whole, dt), dt) - motion_of(whole);
  return {change.head<2>() / dt, change[2] / dt};
}

void move_rigidly(PointBody &body, const std::vector<Vector2> &rest, double dt)
{
  const WholeMotion whole = whole_motion(body);
  const Fit fit(body, whole, rest);
  const double lacking = 1.0 - fit.size(), growth = std::abs(lacking) < largest_growth ? lacking / dt : 0.0;
  Eigen::Vector3d motion = motion_of(whole);
  if (body.in_fluid()) motion = feel_drag(body, whole, growth + chord_rate(whole, dt), dt);
  const Vector2 velocity = motion.head<2>(), centre = whole.centre + dt * velocity;
  const double spin = motion[2] * whole.inertia / fit.rest_inertia;  // what grows keeps its angular momentum
  const double angle = fit.turn.angle() + dt * spin, c = std::cos(angle), s = std::sin(angle);
  for (int i = 0; i < body.size(); ++i) {
    const Vector2 r = rotated(c, s, rest[i] - fit.rest_centre);
    body.x[i] = centre + r;
    body.v[i] = velocity + turned(spin, r) + growth * r;
  }
}

}  // namespace swellflow
