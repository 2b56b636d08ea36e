// An object as the fluid inside it sees it: how it moves and turns.
#pragma once

#include "coupling/dem_engine.h"
#include "fluid/grid.h"
#include "liggghts_plugins/fix_objects.h"
#include "liggghts_plugins/fluid_columns.h"
#include "liggghts_plugins/fluid_partner.h"

namespace swellflow {

/// The points that bear an object's mass: its ring, and its hub unless that only follows the ring. visit(atom), own or ghost.
template <class Visit> void for_each_bearing(const ObjectPoints &object, const DemEngine &points, const Visit &visit)
{
  for (int k = 0; k < object.n_ring; ++k) visit(object.ring[k]);
  if (points.object_point[object.hub][LAMMPS_NS::FixObjects::SPOKES] != 0.0) visit(object.hub);
}

/// The velocity that has carried a point through its last DEM step: without what it has in advance, half a step of weight and of the fluid's impulse, when its
/// integrator keeps these (FluidAhead).
inline Vec<2> drift_velocity(const DemEngine &points, int i, const Triple &gravity)
{
  const double *ahead = points.ahead[i], half_step = ahead[FluidAhead::KNOWS_AHEAD] != 0.0 ? 0.5 * points.time_step() : 0.0;
  Vec<2> v;
  for (int d = 0; d < 2; ++d) v[d] = points.v[i][d] - ahead[FluidAhead::AHEAD_X + d] - half_step * gravity[d];
  return v;
}

/// The fluid inside follows the ring, not the hub: velocity and spin are those of the rigid motion that is nearest to the drift of the
/// ring. 2-D, per unit depth.
struct ObjectMotion {
  Vec<2> centre{};              ///< of mass, of all points
  Vec<2> velocity{};            ///< of the ring's motion, at the centre
  double spin = 0.0;            ///< of the ring: sum of r x v over sum of r^2, about its mean
  double mass = 0.0, inertia = 0.0;  ///< of all points; inertia about the centre
  double inner_inertia = 0.0;   ///< of the fluid inside, over that of points that share its mass as they share the object's
  double swelling = 1.0;        ///< natural swelling ratio
  double natural_area = 0.0;    ///< pi (lambda D0)^2 / 4: that of the disc whose mass the points share
};

/// All points of the object, own or ghost, need current positions and velocities.
ObjectMotion motion_of(const ObjectPoints &object, const DemEngine &points, const Triple &gravity, double fluid_density);

}  // namespace swellflow
