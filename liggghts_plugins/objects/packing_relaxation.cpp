#include "packing_relaxation.h"

#include <algorithm>
#include <cmath>

namespace swellflow {

namespace {

/// Bodies are packed with radii larger by this share, so that overlaps that have become smaller than it are none.
constexpr double slack = 2e-4;
constexpr int most_steps = 3000;

/// Along x and y, and turning times the body's gyration.
struct Motion {
  Vector2 x = Vector2::Zero();
  double turn = 0.0;

  double dot(const Motion &other) const { return x.dot(other.x) + turn * other.turn; }
};

double dot(const std::vector<Motion> &a, const std::vector<Motion> &b)
{
  double sum = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k) sum += a[k].dot(b[k]);
  return sum;
}

struct Overlaps {
  std::vector<Motion> forces;
  double deepest = 0.0;       ///< over the two radii, by which circles truly overlap
  double squares = 0.0;       ///< sum of the squares of all, with the slack
};

class Relaxation {
public:
  explicit Relaxation(PackedBodies &bodies) : bodies_(bodies) {}

  Overlaps overlaps()
  {
    if (bodies_.pairs_are_stale()) bodies_.find_pairs(0.5 * bodies_.mean_radius());
    Overlaps found;
    found.forces.resize(bodies_.bodies());
    for (const auto &[i, j] : bodies_.pairs()) {
      const double reach = (1.0 + slack) * (bodies_.discs()[i].radius + bodies_.discs()[j].radius);
      const Vector2 way = bodies_.task().room->box().difference(bodies_.at(j), bodies_.at(i));
      const double distance_squared = way.squaredNorm();
      if (distance_squared >= reach * reach) continue;
      const double distance = std::sqrt(distance_squared), depth = reach - distance;
      const Vector2 push = distance > 0.0 ? Vector2(way * (depth / distance)) : Vector2(depth, 0.0);
      count(found, depth, reach);
      add(found, i, -push);
      add(found, j, push);
    }
    for (int body = 0; body < bodies_.bodies(); ++body)
      for (int disc = bodies_.first_disc(body); disc < bodies_.first_disc(body + 1); ++disc) push_from_walls(found, disc);
    return found;
  }

  void move(const std::vector<Motion> &by, double factor)
  {
    for (int body = 0; body < bodies_.bodies(); ++body) {
      Placement placement = bodies_.placements()[body];
      placement.centre += factor * by[body].x;
      placement.angle += factor * by[body].turn / bodies_.gyration(body);
      bodies_.place(body, placement);
    }
  }

private:
  void push_from_walls(Overlaps &found, int disc)
  {
    const double reach = (1.0 + slack) * bodies_.discs()[disc].to_wall;
    walls_.clear();
    bodies_.task().room->walls_near(bodies_.at(disc), reach, walls_);
    for (const NearWall &wall : walls_) {
      count(found, reach - wall.distance, reach);
      add(found, disc, (reach - wall.distance) * wall.inwards);
    }
  }
  static void count(Overlaps &found, double depth, double reach)
  {
    found.deepest = std::max(found.deepest, depth / reach - slack);
    found.squares += depth * depth;
  }
  void add(Overlaps &found, int disc, const Vector2 &force) const
  {
    const int body = bodies_.discs()[disc].body;
    if (body < 0) return;
    found.forces[body].x += force;
    if (bodies_.task().turning) found.forces[body].turn += cross(bodies_.at(disc) - bodies_.placements()[body].centre, force) / bodies_.gyration(body);
  }

  PackedBodies &bodies_;
  std::vector<NearWall> walls_;
};

}  // namespace

// Fast inertial relaxation: Bitzek, Koskinen, Gaehler, Moseler, Gumbsch, Phys. Rev. Lett. 97, 170201 (2006), with their parameters; all masses and stiffnesses are 1.
bool relax_overlaps(PackedBodies &bodies)
{
  constexpr double first_step = 0.1, longest_step = 0.5, first_alpha = 0.1;
  Relaxation relaxation(bodies);
  std::vector<Motion> velocities(bodies.bodies());
  double dt = first_step, alpha = first_alpha;
  int downhill = 0;
  for (int step = 0; step < most_steps; ++step) {
    const Overlaps now = relaxation.overlaps();
    if (now.deepest <= 0.0) return true;
    const double force = std::sqrt(dot(now.forces, now.forces)), speed = std::sqrt(dot(velocities, velocities));
    if (force < 1e-3 * std::sqrt(now.squares)) return false;  // in balance, and yet they overlap
    if (dot(now.forces, velocities) > 0.0) {
      for (std::size_t k = 0; k < velocities.size(); ++k) {
        velocities[k].x = (1.0 - alpha) * velocities[k].x + alpha * speed / force * now.forces[k].x;
        velocities[k].turn = (1.0 - alpha) * velocities[k].turn + alpha * speed / force * now.forces[k].turn;
      }
      if (++downhill > 5) dt = std::min(1.1 * dt, longest_step), alpha *= 0.99;
    } else {
      std::fill(velocities.begin(), velocities.end(), Motion{});
      downhill = 0, dt *= 0.5, alpha = first_alpha;
    }
    double fastest = 0.0;
    for (std::size_t k = 0; k < velocities.size(); ++k) {
      velocities[k].x += dt * now.forces[k].x;
      velocities[k].turn += dt * now.forces[k].turn;
      fastest = std::max(fastest, std::sqrt(velocities[k].dot(velocities[k])));
    }
    const double farthest = 0.5 * bodies.mean_radius();
    relaxation.move(velocities, fastest * dt > farthest ? farthest / fastest : dt);
  }
  return false;
}

}  // namespace swellflow
