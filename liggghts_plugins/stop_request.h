// Ends a run after a signal, with a restart file, in the same step on all ranks. LIGGGHTS itself looks on each rank for itself: a signal to one of them would leave the others waiting.
#pragma once

#include "stop_signals.h"

namespace LAMMPS_NS {

class LAMMPS;

class StopRequest {
 public:
  explicit StopRequest(LAMMPS *lmp) : lmp_(lmp) {}

  /// At the beginning of a step after which the state can be saved. Collective.
  void look();
  /// The same for steps so short that to ask all ranks in each would cost time: only when some hundredths of a second have passed.
  void look_now_and_then();
  /// At the end of that step.
  void end_run_if_agreed();

 private:
  void prepare(swellflow::stop_signals::Wish);

  LAMMPS *lmp_;
  bool stopping_ = false;
  double last_look_ = 0.0;
  int interval_ = 1, steps_left_ = 0;
};

/// Whether the script was ended by a signal; tells where to go on from.
bool report_stop(LAMMPS *);

}  // namespace LAMMPS_NS
