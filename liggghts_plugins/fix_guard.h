// Looks at limits before the first step and at the state of the scene in between, and ends what cannot go well. Made with the box, in every scene.
#pragma once

#include <string>
#include <vector>

#include "crossing_look.h"
#include "fix.h"
#include "guard.h"
#include "limits.h"
#include "state_look.h"

namespace LAMMPS_NS {

class FixGuard : public Fix, public swellflow::KnowsFigures {
 public:
  static constexpr const char *ID = "guard";

  FixGuard(class LAMMPS *, int, char **);

  int setmask() override;
  void setup(int) override;
  void pre_initial_integrate() override;
  void end_of_step() override;
  void post_run() override;
  void add_accuracy(std::vector<swellflow::Figure> &figures) override;

  void set_mode(swellflow::GuardMode mode) { mode_ = mode; }
  /// Ends the run where a figure is poor, or warns, as the mode says. Collective.
  void judge(const std::vector<swellflow::Figure> &limits);

 private:
  void find_writers();
  void check_limits();
  bool is_due() const;
  void look();
  void follow_areas();
  void look_for_crossings();
  void object_fails(const std::string &message);
  void warn_once(const swellflow::Figure &figure, double bound);

  swellflow::GuardMode mode_ = swellflow::GuardMode::refuse;
  double step_of_limits_ = 0.0;       // that they were checked for
  bigint looked_at_ = -1;             // step
  int looks_ = 0;                     // in this run
  std::vector<int> written_every_;    // steps, by the fixes that write
  StateLook state_;
  AreaBalance areas_;
  CrossingLook crossing_;
  std::vector<std::string> warned_;   // names of figures
  bool warned_of_objects_ = false;
};

/// Null before there is a box.
FixGuard *find_guard(class LAMMPS *);

}  // namespace LAMMPS_NS
