// Values that stay with each atom as it migrates.
#pragma once

#include <string>

namespace LAMMPS_NS {

class FixPropertyAtom;
class LAMMPS;

/// A fix property/atom of that name, its columns zero or as a restart file has them. For post_create. Collective.
FixPropertyAtom *add_per_atom_values(LAMMPS *lmp, const std::string &name, int columns, bool on_ghosts);

}  // namespace LAMMPS_NS
