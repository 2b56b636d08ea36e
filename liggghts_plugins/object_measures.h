// Measures of the objects of a scene, as they are now.
#pragma once

#include <vector>

#include "objects/measures.h"

namespace LAMMPS_NS {

class LAMMPS;

/// Of the objects of a group, on the rank that owns the hub. Nothing before the first run, and after a command that moved atoms about, until the next. Collective;
/// atom->f must be whole: at the end of a step, in setup (require_whole_forces), or when LIGGGHTS' output asks.
std::vector<swellflow::ObjectMeasures> measure_objects(LAMMPS *lmp, int groupbit);

}  // namespace LAMMPS_NS
