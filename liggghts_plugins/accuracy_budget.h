// How exact a run has been, in one table.
#pragma once

namespace LAMMPS_NS {

class LAMMPS;

/// On screen and log, by rank 0: each figure of accuracy_of() beside its bounds, a plain word for it, and for the worst what would better it most. Nothing without figures. Collective.
void print_accuracy_budget(LAMMPS *lmp);

}  // namespace LAMMPS_NS
