// The guard as others see it: what they ask of it, and how a run that went wrong ends.
#pragma once

#include <string>

#include "limits.h"

namespace LAMMPS_NS {

class Fix;
class LAMMPS;

/// A figure that changes during a run, looked at in a step. Collective.
void judge(LAMMPS *lmp, const swellflow::Figure &limit);

/// The end of a run that went wrong while it ran: a LIGGGHTS error, on all ranks together, that says what happened and which restart file is the last good one.
[[noreturn]] void end_run(LAMMPS *lmp, const Fix &fix, const std::string &what_happened);

}  // namespace LAMMPS_NS

namespace swellflow {

/// What becomes of a limit that is broken: the run is refused or ends, a warning is given, nothing.
enum class GuardMode { refuse, warn, off };

/// The command `guard`. In force until the next one, over `clear` too.
void set_guard(LAMMPS_NS::LAMMPS *lmp, int narg, char **arg);
/// The hidden fix, made when it is missing. Collective.
void make_guard(LAMMPS_NS::LAMMPS *lmp);

}  // namespace swellflow
