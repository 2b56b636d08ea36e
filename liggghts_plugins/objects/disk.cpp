#include "disk.h"

#include <cmath>
#include <numbers>

namespace swellflow {

using std::numbers::pi;

double Disk::mass() const { return density * 0.25 * pi * diameter * diameter; }

double Disk::hub_mass() const { return share == MassShare::hub_half ? 0.5 * mass() : mass() / (ring_points + 1); }

double Disk::ring_point_mass() const { return (mass() - hub_mass()) / ring_points; }

double Disk::ring_spring_length() const { return diameter * std::sin(pi / ring_points); }

Vector2 Disk::ring_point(int k) const
{
  const double angle = 2.0 * pi * k / ring_points;
  return 0.5 * diameter * Vector2(std::cos(angle), std::sin(angle));
}

}  // namespace swellflow
