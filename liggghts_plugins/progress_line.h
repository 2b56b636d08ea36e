// One line on the screen that says how far a run is, how long it will take, and what the time goes into.
#pragma once

#include "pointers.h"
#include "step_clock.h"

namespace LAMMPS_NS {

class ProgressLine : protected Pointers {
 public:
  explicit ProgressLine(class LAMMPS *lmp) : Pointers(lmp) {}

  void start(const swellflow::StepClock &clock);
  void step(const swellflow::StepClock &clock);  ///< prints at most every ten seconds
  void finish(const swellflow::StepClock &clock);

 private:
  struct Spent {
    double wall = 0.0, fluid = 0.0, coupling = 0.0, springs = 0.0, contacts = 0.0;
  };
  Spent spent(const swellflow::StepClock &clock) const;
  void print(const Spent &now);

  Spent at_start_;
  double last_print_ = 0.0;
  bigint first_step_ = 0;
};

}  // namespace LAMMPS_NS
