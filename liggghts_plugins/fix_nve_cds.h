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
  enum class Part { kick, kick_and_drift };
  /// What a step changes of a point, and by what.
  struct Motion {
    double *x, *v;
    const double *f;
    double mass;
  };
  template <Part part> void half_step();
  template <Part part> void half_step_of(const Motion &point) const;
  template <Part part> void half_step_in_fluid(const Motion &point, const double *law, double *impulse) const;
  void drift(int i);
  double mass_of(int i) const;

  double dt_ = 0.0, half_step_ = 0.0;  // the latter times what makes velocities of forces over masses
};

}  // namespace LAMMPS_NS
