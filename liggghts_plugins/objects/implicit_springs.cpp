#include "implicit_springs.h"

#include <algorithm>
#include <cmath>

#include "orientation.h"
#include "rigid_motion.h"

namespace swellflow {

namespace {

constexpr int most_iterations = 30;
constexpr int most_halvings = 8;
/// Newton's method has converged when the error that is left is below this share of the object's size.
constexpr double tolerance = 1e-13;
/// A change this small leaves an error far below the tolerance, whatever the rate of convergence turns out to be.
constexpr double small_at_once = 1e-9;
/// No point goes farther in an iteration, in object sizes: far from the solution Newton's method may point anywhere.
constexpr double longest_change = 0.25;
/// Changes smaller than this need no check that they go downhill.
constexpr double surely_downhill = 1e-3;
constexpr double shortest_share = 1e-4;

double size_of(const PointBody &body)
{
  double square = 0.0;
  for (const Vector2 &x : body.x) square = std::max(square, (x - body.x.front()).squaredNorm());
  return std::sqrt(square);
}

/// An axial part along n n^T and a transverse part: the derivative of a force along n.
Matrix2 stiffness_block(const Vector2 &n, double axial, double transverse)
{
  const double difference = axial - transverse, xy = difference * n.x() * n.y();
  Matrix2 block;
  block << transverse + difference * n.x() * n.x(), xy, xy, transverse + difference * n.y() * n.y();
  return block;
}

}  // namespace

bool ImplicitSprings::advance(PointBody &body, const SpringSet &springs, const std::vector<Vector2> &g, double dt)
{
  x_ = body.x;
  v_ = body.v;
  impulse_ = body.impulse;
  for (int halvings = 0; halvings <= most_halvings; ++halvings) {
    const int parts = 1 << halvings;
    bool good = true;
    for (int part = 0; part < parts && good; ++part) good = solve(body, springs, g, dt / parts);
    if (good) return true;
    body.x = x_;
    body.v = v_;
    body.impulse = impulse_;
  }
  return false;
}

bool ImplicitSprings::solve(PointBody &body, const SpringSet &springs, const std::vector<Vector2> &g, double dt)
{
  const int n = body.size();
  const WholeMotion before = whole_motion(body);
  x0_ = body.x;
  v0_ = body.v;
  guess(body, springs, g, dt, before);
  if (!iterate(body, springs, g, dt)) return false;
  for (int i = 0; i < n; ++i) {
    body.v[i] = ((x1_[i] - x0_[i]) / dt - (1.0 - theta_) * v0_[i]) / theta_;
    body.x[i] = x1_[i];
  }
  restore_momentum(body, dt, before);
  turn_by_spin(body, dt, before);
  return true;
}

/// The body as it would turn and deform by its velocities; or only turn, when it would go too far. In a fluid it goes as a rigid body would, so that what is left to be found is small
/// against its size also where weight and buoyancy are large and all but cancel.
void ImplicitSprings::guess(const PointBody &body, const SpringSet &springs, const std::vector<Vector2> &g, double dt, const WholeMotion &before)
{
  const int n = body.size();
  const RigidAcceleration drag = body.in_fluid() ? drag_as_a_whole(body, before, dt) : RigidAcceleration{};
  const Vector2 way = dt * (before.velocity + theta_ * dt * drag.linear);
  const double spin = before.spin() + theta_ * dt * drag.angular, c = std::cos(dt * spin), s = std::sin(dt * spin);
  double farthest = 0.0;
  x1_.resize(n);
  trial_.resize(n);
  for (int i = 0; i < n; ++i) {
    const Vector2 r = x0_[i] - before.centre, deformation = dt * (v0_[i] - before.velocity - turned(before.spin(), r));
    trial_[i] = before.centre + way + rotated(c, s, r);
    x1_[i] = trial_[i] + rotated(c, s, deformation);
    farthest = std::max(farthest, deformation.squaredNorm());
  }
  if (energy_ == SpringEnergy::conserve || std::sqrt(farthest) < surely_downhill * size_of(body)) return;
  if (potential(body, springs, g, dt, trial_) < potential(body, springs, g, dt, x1_)) x1_.swap(trial_);
}

/// The stiffness with compressed springs' part that pushes sideways may be indefinite: then that part is left out, which slows convergence but keeps its limit.
bool ImplicitSprings::iterate(const PointBody &body, const SpringSet &springs, const std::vector<Vector2> &g, double dt)
{
  const int n = body.size();
  const double size = size_of(body);
  if (!(size > 0.0) || !std::isfinite(size)) return false;
  double before = 0.0;
  for (int iteration = 0; iteration < most_iterations; ++iteration) {
    ++iterations_;
    assemble(body, springs, g, dt, false);
    if (!system_.solve()) {
      assemble(body, springs, g, dt, true);
      if (!system_.solve()) return false;
    }
    const double change = largest_change(n) / size;
    if (!std::isfinite(change)) return false;
    const double share = go_downhill(body, springs, g, dt, change);
    const double rate = iteration > 0 ? change / before : 1.0;
    if (share == 1.0 && (change <= (iteration > 0 ? tolerance : small_at_once) || (rate < 0.5 && change * rate <= tolerance))) return true;
    before = share * change;
  }
  return false;
}

/// Adds the change, or a share of it, to x1; returns the share.
double ImplicitSprings::go_downhill(const PointBody &body, const SpringSet &springs, const std::vector<Vector2> &g, double dt, double change)
{
  const int n = body.size();
  double share = std::min(1.0, longest_change / change);
  const bool sure = energy_ == SpringEnergy::conserve || change < surely_downhill;
  const double before = sure ? 0.0 : potential(body, springs, g, dt, x1_);
  trial_.resize(n);
  while (true) {
    for (int i = 0; i < n; ++i) trial_[i] = x1_[i] + share * system_.solution(i);
    if (sure || share < shortest_share || potential(body, springs, g, dt, trial_) <= before) break;
    share *= 0.5;
  }
  x1_.swap(trial_);
  return share;
}

/// What backward Euler's step makes smallest (its derivative is the right side of Newton's step): so the springs never hold more than the step began with.
double ImplicitSprings::potential(const PointBody &body, const SpringSet &springs, const std::vector<Vector2> &g, double dt, const std::vector<Vector2> &x) const
{
  double sum = 0.0;
  for (int i = 0; i < body.size(); ++i) {
    const Vector2 way = x[i] - x0_[i];
    sum += 0.5 * body.mass[i] * (way - dt * v0_[i]).squaredNorm() - dt * dt * g[i].dot(way);
    if (body.in_fluid()) sum += 0.5 * dt * body.kappa[i] * way.squaredNorm() - dt * dt * body.a[i].dot(way);
  }
  for_each_spring(springs, [&](int a, int b, const Spring &spring) {
    const double xi = (x[a] - x[b]).norm();
    sum += 0.5 * dt * dt * spring.stiffness * (xi - spring.length) * (xi - spring.length);
    if (spring.dashpot > 0.0) sum += 0.5 * dt * spring.dashpot * std::pow(xi - (x0_[a] - x0_[b]).norm(), 2);
  });
  return sum;
}

double ImplicitSprings::largest_change(int n) const
{
  double square = 0.0;
  for (int i = 0; i < n; ++i) {
    const double now = system_.solution(i).squaredNorm();
    if (!(now <= square)) square = now;  // also when it is not a number
  }
  return std::sqrt(square);
}

/// A = (m + dt kappa) I + theta dt^2 K and the right side of Newton's step, at x1.
void ImplicitSprings::assemble(const PointBody &body, const SpringSet &springs, const std::vector<Vector2> &g, double dt, bool clamped)
{
  const int n = body.size();
  system_.start(springs.ring_points(), springs.has_spokes());
  for (int i = 0; i < n; ++i) {
    const Vector2 way = x1_[i] - x0_[i];
    double weight = body.mass[i];
    Vector2 r = theta_ * dt * dt * g[i] - body.mass[i] * (way - dt * v0_[i]);
    if (body.in_fluid()) {
      const double drag = dt * body.kappa[i];
      weight += drag;
      r += theta_ * dt * dt * body.a[i] - drag * (way - (1.0 - theta_) * dt * v0_[i]);
    }
    system_.diagonal(i) = weight * Matrix2::Identity();
    system_.right_side(i) = r;
  }
  for_each_spring(springs, [&](int a, int b, const Spring &spring) { add_spring(a, b, spring, dt, clamped); });
}

/// Tension T = k (xi - L) + c dxi/dt, taken at the end of the step along the spring as it is then (dissipate), or, with the mean lengths and the mean direction of
/// both ends of the step, as the difference of the energy over that of the length (conserve).
void ImplicitSprings::add_spring(int a, int b, const Spring &spring, double dt, bool clamped)
{
  const Vector2 d1 = x1_[a] - x1_[b], d0 = x0_[a] - x0_[b];
  const double xi1 = d1.norm(), xi0 = d0.norm();
  const bool conserve = energy_ == SpringEnergy::conserve;
  const Vector2 d = conserve ? Vector2(0.5 * (d0 + d1)) : d1;
  const double xi = conserve ? 0.5 * (xi0 + xi1) : xi1, norm = conserve ? d.norm() : xi1, scale = theta_ * dt * dt;
  Matrix2 block = scale * spring.stiffness * Matrix2::Identity();  // two points on one spot: no direction, no force
  if (norm > 0.0) {
    const double tension = spring.stiffness * (xi - spring.length) + spring.dashpot * (xi1 - xi0) / dt;
    const double sideways = theta_ * tension / xi;
    block = stiffness_block(d / norm, scale * (theta_ * spring.stiffness + spring.dashpot / dt), scale * (clamped ? std::max(0.0, sideways) : sideways));
    const Vector2 pull = scale * tension / xi * d;
    system_.right_side(a) -= pull;
    system_.right_side(b) += pull;
  }
  system_.diagonal(a) += block;
  system_.diagonal(b) += block;
  system_.coupling(a, b) -= block;
}

/// The fluid's impulse acts at the places where the fluid knows the points to be: those before the step.
void ImplicitSprings::restore_momentum(PointBody &body, double dt, const WholeMotion &before)
{
  Vector2 momentum = before.mass * before.velocity;
  double angular_momentum = before.angular_momentum;
  for (int i = 0; body.in_fluid() && i < body.size(); ++i) {
    const Vector2 impulse = dt * (body.a[i] - body.kappa[i] * body.v[i]);
    body.impulse[i] += impulse;
    momentum += impulse;
    angular_momentum += cross(x0_[i] - before.centre, impulse);
  }
  const WholeMotion now = whole_motion(body);
  const Vector2 velocity = momentum / before.mass, change = velocity - now.velocity;
  const Vector2 shift = before.centre + dt * ((1.0 - theta_) * before.velocity + theta_ * velocity) - now.centre;
  const double spin = (angular_momentum - now.angular_momentum) / now.inertia;
  for (int i = 0; i < body.size(); ++i) {
    body.v[i] += change + turned(spin, body.x[i] - now.centre);
    body.x[i] += shift;
  }
}

/// The angle by which the points have turned is that of the rotation that takes them nearest to where they are; to first order it is dt times the spin.
void ImplicitSprings::turn_by_spin(PointBody &body, double dt, const WholeMotion &before)
{
  const WholeMotion now = whole_motion(body);
  BestFit turn;
  for (int i = 0; i < body.size(); ++i) turn.add(x0_[i] - before.centre, body.x[i] - now.centre, body.mass[i]);
  const double angle = dt * ((1.0 - theta_) * before.spin() + theta_ * now.spin()) - turn.angle();
  const double c = std::cos(angle), s = std::sin(angle);
  for (int i = 0; i < body.size(); ++i) {
    body.x[i] = now.centre + rotated(c, s, body.x[i] - now.centre);
    body.v[i] = now.velocity + rotated(c, s, body.v[i] - now.velocity);
  }
}

}  // namespace swellflow
