#include "coupling/object_motion.h"

#include <algorithm>
#include <numbers>

namespace swellflow {

namespace {

/// About the hub, so that far from the origin no digits are lost.
void find_mass(const ObjectPoints &object, const DemEngine &points, ObjectMotion &motion)
{
  const double *hub = points.x[object.hub];
  double x = 0.0, y = 0.0, square = 0.0;
  for_each_bearing(object, points, [&](int i) {
    const double m = points.mass[i], rx = points.x[i][0] - hub[0], ry = points.x[i][1] - hub[1];
    motion.mass += m;
    x += m * rx;
    y += m * ry;
    square += m * (rx * rx + ry * ry);
  });
  x /= motion.mass;
  y /= motion.mass;
  motion.centre = {hub[0] + x, hub[1] + y};
  motion.inertia = square - motion.mass * (x * x + y * y);
}

/// Sums about the first ring point's place and velocity; then by the theorem of parallel axes about the mean.
void find_velocity(const ObjectPoints &object, const DemEngine &points, const Triple &gravity, ObjectMotion &motion)
{
  const double *first = points.x[object.ring[0]], n = object.n_ring;
  const Vec<2> v_first = drift_velocity(points, object.ring[0], gravity);
  double x = 0.0, y = 0.0, u = 0.0, v = 0.0, turn = 0.0, square = 0.0;
  for (int k = 0; k < object.n_ring; ++k) {
    const double *at = points.x[object.ring[k]], rx = at[0] - first[0], ry = at[1] - first[1];
    const Vec<2> drift = drift_velocity(points, object.ring[k], gravity);
    const double du = drift[0] - v_first[0], dv = drift[1] - v_first[1];
    x += rx;
    y += ry;
    u += du;
    v += dv;
    turn += rx * dv - ry * du;
    square += rx * rx + ry * ry;
  }
  turn -= (x * v - y * u) / n;
  square -= (x * x + y * y) / n;
  if (square > 0.0) motion.spin = turn / square;
  const double arm_x = motion.centre[0] - (first[0] + x / n), arm_y = motion.centre[1] - (first[1] + y / n);
  motion.velocity = {v_first[0] + u / n - motion.spin * arm_y, v_first[1] + v / n + motion.spin * arm_x};
}

}  // namespace

ObjectMotion motion_of(const ObjectPoints &object, const DemEngine &points, const Triple &gravity, double fluid_density)
{
  ObjectMotion motion;
  find_mass(object, points, motion);
  find_velocity(object, points, gravity, motion);
  using Column = LAMMPS_NS::FixObjects;
  const double *topology = points.object_point[object.hub];
  const double lambda = points.object_size[object.hub][Column::LAMBDA], diameter = topology[Column::DIAMETER] * lambda;
  motion.swelling = lambda;
  motion.natural_area = std::numbers::pi / 4.0 * diameter * diameter;
  const double mean_square = lambda * lambda * topology[Column::MEAN_SQUARE_RADIUS];
  motion.inner_inertia = mean_square * motion.mass / motion.inertia;
  // A ring without spokes is a membrane about its fluid, which has no mass at the fluid's density; below that it turns as a disc of its density would.
  if (topology[Column::SPOKES] == 0.0) motion.inner_inertia = std::min(1.0, motion.inner_inertia * (1.0 + motion.mass / (fluid_density * motion.natural_area)));
  return motion;
}

}  // namespace swellflow
