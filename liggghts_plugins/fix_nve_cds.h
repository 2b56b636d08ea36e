// Explicit motion of points: velocity Verlet, with the fluid's linear drag law taken implicitly. Points do not spin.
#pragma once

#include "fix.h"

namespace LAMMPS_NS {

class FixNveCds : public Fix {
 public:
  FixNveCds(class LAMMPS *, int, char **);

  int setmask() override;
  void init() override;
  void initial_integrate(int) override;
  void final_integrate() override;

 private:
  void kick_half_a_step();
  void kick(int i, double half_step, double mass);
  void kick_in_fluid(int i, double half_step, double mass, const double *law, double *impulse);
  double mass_of(int i) const;
  void drift_a_step();
};

}  // namespace LAMMPS_NS
