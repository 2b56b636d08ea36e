// An object as the fluid inside it sees it: how it moves and turns.
#pragma once

#include "coupling/dem_engine.h"
#include "fluid/grid.h"
#include "liggghts_plugins/fluid_partner.h"

namespace swellflow {

/// The fluid inside follows the ring, not the hub: centre, velocity and spin are means over the ring points. 2-D, per unit depth.
struct ObjectMotion {
  Vec<2> centre{}, velocity{};
  double spin = 0.0;            ///< sum of r x v over sum of r^2, about the centre
  double mass = 0.0;            ///< of all points
  double natural_area = 0.0;    ///< pi (lambda D0)^2 / 4: that of the disc whose mass the points share
};

/// All points of the object, own or ghost, need current positions and velocities.
ObjectMotion motion_of(const ObjectPoints &object, const DemEngine &points);

}  // namespace swellflow
