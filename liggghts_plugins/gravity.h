// The acceleration by LIGGGHTS' fix gravity, of which a script may have several.
#pragma once

#include <vector>

#include "fluid_partner.h"

namespace LAMMPS_NS {

class LAMMPS;

/// What one fix gravity gives to the atoms of its group.
struct Gravity {
  int groupbit = 0;
  swellflow::Triple acceleration{};
};

/// As they are now, in the order of the script.
std::vector<Gravity> gravities(LAMMPS *lmp);
/// Their sum, for matter that belongs to all groups.
swellflow::Triple total_gravity(LAMMPS *lmp);

}  // namespace LAMMPS_NS
