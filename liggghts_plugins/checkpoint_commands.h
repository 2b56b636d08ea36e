// LIGGGHTS' write_restart and read_restart, which our files go through. `stock`: LIGGGHTS' own command.
#pragma once

#include <functional>

namespace LAMMPS_NS {
class LAMMPS;
}

namespace swellflow {

using StockCommand = std::function<void(int narg, char **arg)>;

/// To a name of its own first, so that a file of the name given is always complete.
void write_checkpoint(LAMMPS_NS::LAMMPS *, int narg, char **arg, const StockCommand &stock);
/// The newest complete one where the name has a '*'. What is damaged, cut short or foreign is refused.
void read_checkpoint(LAMMPS_NS::LAMMPS *, int narg, char **arg, const StockCommand &stock);

}  // namespace swellflow
