// What the fixes that move points have in common.
#pragma once

namespace LAMMPS_NS {

class Fix;
class LAMMPS;

/// Whether a fix moves the points of its group and, while there is a fluid, feels the fluid's law and sums up what impulse it gave.
bool knows_fluid_law(const Fix &fix);
/// Whether a fix moves whole objects and takes care of their springs itself, so that these are no forces to it.
bool solves_springs(const Fix &fix);
/// Whether a fix moves each point by the forces on it, springs among them.
bool takes_springs_as_forces(const Fix &fix);
/// Whether some atom is in the groups of both. Collective.
bool share_atoms(LAMMPS *lmp, const Fix &one, const Fix &other);
/// A LIGGGHTS error that names both when another integrator moves a point of this one. Collective.
void require_one_integrator(LAMMPS *lmp, const Fix &asking);
/// A per-atom vector that fix fluid/ib makes; null in a scene without a fluid. To be looked up each time: an unfix followed by a run with 'pre no' takes it
/// away without a word to other fixes.
double **fluid_columns(LAMMPS *lmp, const char *name);

/// Velocities of the group's atoms are from now on what they seem: nothing in them is in advance of the fluid's impulse (FluidAhead).
void forget_what_is_ahead(LAMMPS *lmp, const Fix &asking);

}  // namespace LAMMPS_NS
