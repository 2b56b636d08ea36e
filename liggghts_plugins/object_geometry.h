// Where an object is, as this rank sees it.
#pragma once

#include <vector>

#include "fluid_partner.h"
#include "objects/vector2.h"

namespace LAMMPS_NS {

class LAMMPS;

/// The vertices of an object's outline relative to its hub: each lies OUTLINE_OFFSET * lambda beyond its ring point.
std::vector<swellflow::Vector2> outline_of(LAMMPS *lmp, const swellflow::ObjectPoints &object);

/// Visits an object's ring points, then its hub: visit(i), the index of the point or of its image near the hub.
template <typename Visit>
void for_each_point(const swellflow::ObjectPoints &object, const Visit &visit)
{
  for (int k = 0; k < object.n_ring; k++) visit(object.ring[k]);
  visit(object.hub);
}

}  // namespace LAMMPS_NS
