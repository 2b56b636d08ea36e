// The bins in which LIGGGHTS sorts atoms.
#pragma once

namespace LAMMPS_NS {

class Atom;

/// The size that `atom_modify sort` gave them, which can be changed between runs; 0: none, LIGGGHTS takes half the cut-off.
double &sort_bin_size(Atom &atom);

}  // namespace LAMMPS_NS
