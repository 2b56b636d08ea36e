// A disc of points and springs for tests of what moves it.
#pragma once

#include <cmath>
#include <numbers>
#include <random>

#include "liggghts_plugins/objects/point_body.h"
#include "liggghts_plugins/objects/spring_law.h"

namespace swellflow_test {

using swellflow::Vector2;

struct RingObject {
  int ring_points = 20;
  double diameter = 1.0, mass = 2.0;  ///< half the mass on the hub
  bool spokes = true;
  swellflow::SpringLaw law{.stiffness = 1.0};

  double ring_mass() const { return mass / ring_points * (spokes ? 0.5 : 1.0); }

  swellflow::PointBody body(bool in_fluid = false) const
  {
    swellflow::PointBody body;
    body.resize(ring_points + spokes, in_fluid);
    for (int k = 0; k < body.size(); ++k) {
      const double angle = 2.0 * std::numbers::pi * k / ring_points;
      body.x[k] = k < ring_points ? Vector2(0.5 * diameter * Vector2(std::cos(angle), std::sin(angle))) : Vector2(Vector2::Zero());
      body.mass[k] = k < ring_points ? ring_mass() : 0.5 * mass;
      body.v[k].setZero();
      body.force[k].setZero();
      if (!in_fluid) continue;
      body.kappa[k] = 0.0;
      body.a[k].setZero();
      body.impulse[k].setZero();
    }
    return body;
  }

  swellflow::SpringSet springs(double lambda = 1.0) const
  {
    swellflow::SpringSet set;
    const swellflow::SpringScale scale = law.scale(lambda, 1.0);
    set.ring.assign(ring_points, scale * law.natural(diameter * std::sin(std::numbers::pi / ring_points), ring_mass(), ring_mass()));
    if (spokes) set.spokes.assign(ring_points, scale * law.natural(0.5 * diameter, ring_mass(), 0.5 * mass));
    return set;
  }
};

inline double kinetic_energy(const swellflow::PointBody &body)
{
  double sum = 0.0;
  for (int i = 0; i < body.size(); ++i) sum += 0.5 * body.mass[i] * body.v[i].squaredNorm();
  return sum;
}

inline double spring_energy(const swellflow::PointBody &body, const swellflow::SpringSet &springs)
{
  double sum = 0.0;
  for_each_spring(springs, [&](int a, int b, const swellflow::Spring &spring) {
    sum += 0.5 * spring.stiffness * std::pow((body.x[a] - body.x[b]).norm() - spring.length, 2);
  });
  return sum;
}

inline Vector2 momentum(const swellflow::PointBody &body)
{
  const swellflow::WholeMotion whole = whole_motion(body);
  return whole.mass * whole.velocity;
}

/// Velocities without order, of that size.
inline void stir(swellflow::PointBody &body, double speed, unsigned seed = 1)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-speed, speed);
  for (Vector2 &v : body.v) v += Vector2(uniform(random), uniform(random));
}

inline void spin_up(swellflow::PointBody &body, double spin)
{
  for (int i = 0; i < body.size(); ++i) body.v[i] += swellflow::turned(spin, body.x[i]);
}

}  // namespace swellflow_test
