// Moves objects as a script tells, whatever acts on them, and shows what the fluid does to them: styles held and prescribed.
#pragma once

#include <array>

#include "fix.h"
#include "fluid_partner.h"
#include "script_value.h"

namespace LAMMPS_NS {

class FixObjects;

class FixPrescribed : public Fix {
 public:
  FixPrescribed(class LAMMPS *, int, char **);

  int setmask() override;
  void post_create() override;
  void init() override;
  void setup(int) override;
  void initial_integrate(int) override;
  void final_integrate() override;
  void write_restart(FILE *) override;
  void restart(char *) override;
  double compute_vector(int) override;

 private:
  enum Value { DRAG, LIFT, TORQUE, VELOCITY_X, VELOCITY_Y, SPIN, N_VALUES };
  using Values = std::array<double, N_VALUES>;

  struct Motion {
    double vx = 0.0, vy = 0.0, spin = 0.0;
  };
  /// What the points of this rank received in a fluid step.
  struct Account {
    double impulse[2] = {0.0, 0.0}, angular_impulse = 0.0, duration = 0.0;
    Motion at_start, at_end;
    bool whole = false;
  };

  void require_no_swelling();
  Motion motion_now();
  void advance(double dx, double dy, double turn);
  void receive_half_a_step();
  void receive(int i, const double *arm, const double *law, const double *inner_force, double *impulse);
  const Values &values();
  template <class Visit> void for_each_own_point(const swellflow::ObjectPoints &object, const Visit &visit) const;

  swellflow::ScriptValue vx_, vy_, spin_;
  FixObjects *objects_ = nullptr;
  Motion motion_;               // as of the present step
  Account under_way_, last_;    // fluid steps
  Values values_{};
  bool values_known_ = false, restored_ = false;
};

}  // namespace LAMMPS_NS
