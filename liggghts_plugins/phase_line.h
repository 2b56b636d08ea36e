// One line after a run that says what the fluid's time went into.
#pragma once

#include <vector>

#include "fluid_partner.h"
#include "pointers.h"

namespace LAMMPS_NS {

class PhaseLine : protected Pointers {
 public:
  explicit PhaseLine(class LAMMPS *lmp) : Pointers(lmp) {}

  /// Shares of the time since the last call, over all ranks. Collective.
  void print(const std::vector<swellflow::PhaseTime> &times);

 private:
  std::vector<double> seconds_before_;
};

}  // namespace LAMMPS_NS
