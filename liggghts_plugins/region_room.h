// A region of the script as a place for objects.
#pragma once

#include <memory>
#include <string>

#include "objects/packing_room.h"

namespace LAMMPS_NS {

class LAMMPS;

/// As much of the region as lies in the box, in the plane z = 0; nullptr if there is none of this name.
std::shared_ptr<const swellflow::PackingRoom> room_of_region(LAMMPS *lmp, const std::string &id, const swellflow::PlaneBox &box);

}  // namespace LAMMPS_NS
