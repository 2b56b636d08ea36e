#include "coupling/object_motion.h"

#include <numbers>

#include "liggghts_plugins/fix_objects.h"

namespace swellflow {

ObjectMotion motion_of(const ObjectPoints &object, const DemEngine &points)
{
  ObjectMotion motion;
  motion.mass = points.mass[object.hub];
  for (int k = 0; k < object.n_ring; ++k) {
    const int i = object.ring[k];
    motion.mass += points.mass[i];
    for (int d = 0; d < 2; ++d) {
      motion.centre[d] += points.x[i][d] / object.n_ring;
      motion.velocity[d] += points.v[i][d] / object.n_ring;
    }
  }
  double turn = 0.0, square = 0.0;
  for (int k = 0; k < object.n_ring; ++k) {
    const int i = object.ring[k];
    const double rx = points.x[i][0] - motion.centre[0], ry = points.x[i][1] - motion.centre[1];
    turn += rx * points.v[i][1] - ry * points.v[i][0];
    square += rx * rx + ry * ry;
  }
  if (square > 0.0) motion.spin = turn / square;

  using Column = LAMMPS_NS::FixObjects::Column;
  const double *topology = points.object_point[object.hub];
  const double diameter = topology[Column::DIAMETER] * topology[Column::LAMBDA];
  motion.natural_area = std::numbers::pi / 4.0 * diameter * diameter;
  return motion;
}

}  // namespace swellflow
