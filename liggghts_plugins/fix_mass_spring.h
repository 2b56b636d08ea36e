// Springs and dashpots between the points of each object: ring and spokes.
#pragma once

#include <string>

#include "fix.h"
#include "fluid_partner.h"
#include "objects/springs.h"

namespace LAMMPS_NS {

class FixObjects;
class FixPropertyAtom;

class FixMassSpring : public Fix {
 public:
  FixMassSpring(class LAMMPS *, int, char **);

  int setmask() override;
  void post_create() override;
  void pre_delete(bool unfixflag) override;
  void init() override;
  void setup(int) override;
  void post_force(int) override;
  void reset_timestep(bigint) override {}
  void reset_timestep(bigint new_step, bigint old_step) override;
  void write_restart(FILE *) override;
  void restart(char *) override;
  double compute_scalar() override;
  double compute_vector(int) override;

 private:
  struct Totals {
    double energy = 0.0, largest_strain = 0.0, dissipated_power = 0.0, step_over_limit = 0.0;
  };
  template <typename Visit>
  void for_each_spring(const swellflow::ObjectPoints &object, const Visit &visit) const;
  void add_springs();
  void measure_dashpots();
  void add_dashpots();
  void add_pair(double **force, int a, int b, const swellflow::Vector2 &F) const;
  bool damped() const { return law_.damping > 0.0; }
  std::string dashpot_property() const { return std::string("spring_dashpot_") + id; }
  bool holds(const swellflow::ObjectPoints &object) const;
  const Totals &totals();
  double step_over_limit(const swellflow::ObjectPoints &object) const;

  swellflow::SpringLaw law_;
  double restitution_;
  FixObjects *objects_;
  FixPropertyAtom *dashpot_;  // force of the dashpots on each point, at dashpot_step_; null without damping
  bigint dashpot_step_;       // -1: none yet
  Totals totals_;
  bigint totals_step_;  // of totals_; -1: none
};

}  // namespace LAMMPS_NS
