// How stiff contacts are beside the masses that swing on them, and how deep they are; of the scene's granular pair style and its walls.
#pragma once

#include <vector>

#include "limits.h"

namespace LAMMPS_NS {

class LAMMPS;

/// The time step over the longest one with which the stiffest contact of the lightest partners is stable. Nothing without a pair style, or where nothing can meet. Collective.
void add_contact_step(LAMMPS *lmp, std::vector<swellflow::Figure> &figures, double watch, double poor);

/// The deepest overlap of two spheres over the radius of the smaller; LIGGGHTS does not tell those with walls. Collective; between two reneighbourings.
void add_overlap(LAMMPS *lmp, std::vector<swellflow::Figure> &figures);

}  // namespace LAMMPS_NS
