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

Eigen::Vector3d motion_of(const WholeMotion &whole) { return {whole.velocity.x(), whole.velocity.y(), whole.spin()}; }

/// Velocity and spin (about the centre) after the fluid's impulse: m (V1 - V) = dt sum (a - kappa u), I (w1 - w) = dt sum r x (a - kappa u), u = V1 + w1 x r + growth r.
Eigen::Vector3d motion_after_drag(const PointBody &body, const WholeMotion &whole, double growth, double dt)
{
  double kappa = 0.0, kappa_inertia = 0.0, turning = 0.0;
  Vector2 kappa_moment = Vector2::Zero(), pushing = Vector2::Zero();
  for (int i = 0; i < body.size(); ++i) {
    const Vector2 r = body.x[i] - whole.centre;
    kappa += body.kappa[i];
    kappa_moment += body.kappa[i] * r;
    kappa_inertia += body.kappa[i] * r.squaredNorm();
    pushing += body.a[i];
    turning += cross(r, body.a[i]);
  }
  const double linear = whole.mass + dt * kappa, x = dt * kappa_moment.x(), y = dt * kappa_moment.y(), angular = whole.inertia + dt * kappa_inertia;
  Eigen::Matrix3d A;
  A << linear, 0.0, -y, 0.0, linear, x, -y, x, angular;
  const Vector2 momentum = whole.mass * whole.velocity + dt * (pushing - growth * kappa_moment);
  return A.ldlt().solve(Eigen::Vector3d(momentum.x(), momentum.y(), whole.inertia * whole.spin() + dt * turning));
}

/// The same, and each point gets its impulse. What the points are said to have received is what the body has received, to the last digit.
Eigen::Vector3d feel_drag(PointBody &body, const WholeMotion &whole, double growth, double dt)
{
  const Eigen::Vector3d motion = motion_after_drag(body, whole, growth, dt);
  Eigen::Vector3d result = motion_of(whole);
  for (int i = 0; i < body.size(); ++i) {
    const Vector2 r = body.x[i] - whole.centre, impulse = dt * (body.a[i] - body.kappa[i] * (motion.head<2>() + turned(motion[2], r) + growth * r));
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
