// When an output over time is due, and at what time, over several runs and restart files.
#pragma once

#include <cstdio>

#include "lmptype.h"

namespace LAMMPS_NS {

class LAMMPS;

class OutputTimes {
 public:
  explicit OutputTimes(LAMMPS *lmp) : lmp_(lmp) {}

  /// To be called in setup(). Whether something is due before the first step: when the first run begins, and on multiples of `every`;
  /// not within a run that goes on from a restart file, since the one before has written it.
  bool begin_run(int every);
  /// Whether nothing has been written at this step yet; from then on it has. A run that starts where the last one ended meets the same step twice.
  bool take_step();
  /// LIGGGHTS' time, which goes on over a read_restart.
  double time() const;
  /// What an earlier run wrote from this time on is not of this series: this run writes it anew, or begins in its place.
  double own_from() const { return own_from_; }

  void write_restart(FILE *fp) const;
  void restart(const char *buffer);

 private:
  LAMMPS *lmp_;
  bigint last_step_ = -1;      // taken last; -1: none
  bool begun_ = false;
  double own_from_ = 0.0;
  double restart_time_ = -1.0;  // at which an earlier run saved; -1: none did
  double offset_ = 0.0;        // LIGGGHTS counts time anew after read_restart
};

}  // namespace LAMMPS_NS
