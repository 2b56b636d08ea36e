// Files that a script names.
#pragma once

#include <string>

namespace LAMMPS_NS {

class LAMMPS;

/// The contents of a file, the same on every rank because one reads for all. Throws swellflow::OptionError, which `place` begins, on all ranks. Collective.
std::string text_of_file(LAMMPS *lmp, const std::string &place, const std::string &name);

}  // namespace LAMMPS_NS
