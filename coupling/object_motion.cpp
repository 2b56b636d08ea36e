#include "coupling/object_motion.h"

#include <algorithm>
#include <numbers>

namespace swellflow {

namespace {

void find_mass(const ObjectPoints &object, const DemEngine &points, ObjectMotion &motion)
{
  const double *hub = points.x[object.hub];
  for_each_bearing(object, points, [&](int i) { motion.mass += points.mass[i]; });
  motion.centre = {hub[0], hub[1]};
  for_each_bearing(object, points, [&](int i) {
    for (int d = 0; d < 2; ++d) motion.centre[d] += points.mass[i] / motion.mass * (points.x[i][d] - hub[d]);
  });
  for_each_bearing(object, points, [&](int i) {
    for (int d = 0; d < 2; ++d) motion.inertia += points.mass[i] * (points.x[i][d] - motion.centre[d]) * (points.x[i][d] - motion.centre[d]);
  });
}

void find_velocity(const ObjectPoints &object, const DemEngine &points, const Triple &gravity, ObjectMotion &motion)
{
  Vec<2> mean{};
  for (int k = 0; k < object.n_ring; ++k) {
    const Vec<2> v = drift_velocity(points, object.ring[k], gravity);
    for (int d = 0; d < 2; ++d) {
      mean[d] += points.x[object.ring[k]][d] / object.n_ring;
      motion.velocity[d] += v[d] / object.n_ring;
    }
  }
  double turn = 0.0, square = 0.0;
  for (int k = 0; k < object.n_ring; ++k) {
    const double *x = points.x[object.ring[k]], rx = x[0] - mean[0], ry = x[1] - mean[1];
    const Vec<2> v = drift_velocity(points, object.ring[k], gravity);
    turn += rx * v[1] - ry * v[0];
    square += rx * rx + ry * ry;
  }
  if (square > 0.0) motion.spin = turn / square;
  motion.velocity[0] -= motion.spin * (motion.centre[1] - mean[1]);
  motion.velocity[1] += motion.spin * (motion.centre[0] - mean[0]);
}

}  // namespace

ObjectMotion motion_of(const ObjectPoints &object, const DemEngine &points, const Triple &gravity, double fluid_density)
{
  ObjectMotion motion;
  find_mass(object, points, motion);
  find_velocity(object, points, gravity, motion);
  using Column = LAMMPS_NS::FixObjects::Column;
  const double *topology = points.object_point[object.hub];
  const double diameter = topology[Column::DIAMETER] * topology[Column::LAMBDA];
  motion.natural_area = std::numbers::pi / 4.0 * diameter * diameter;
  const double lambda = topology[Column::LAMBDA], mean_square = lambda * lambda * topology[Column::MEAN_SQUARE_RADIUS];
  motion.inner_inertia = mean_square * motion.mass / motion.inertia;
  // A ring without spokes is a membrane about its fluid, which has no mass at the fluid's density; below that it turns as a disc of its density would.
  if (topology[Column::SPOKES] == 0.0) motion.inner_inertia = std::min(1.0, motion.inner_inertia * (1.0 + motion.mass / (fluid_density * motion.natural_area)));
  return motion;
}

}  // namespace swellflow
