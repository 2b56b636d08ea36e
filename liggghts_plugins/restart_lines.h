// What LIGGGHTS keeps of the script's `restart` lines.
#pragma once

#include <vector>

#include "lmptype.h"

namespace LAMMPS_NS {

class Output;

/// Of each `restart` line that is in force: one name, or two that take turns.
struct RestartLine {
  int every;  ///< 0: a variable tells
  std::vector<char **> names;  ///< may be replaced by what new[] gives
};
std::vector<RestartLine> restart_lines(Output &);
/// The step of the next restart file; one beyond the run when there is none.
bigint next_restart(Output &);

}  // namespace LAMMPS_NS
