// Springs and dashpots between the points of each object: ring and spokes.
#pragma once

#include <string>
#include <vector>

#include "fix.h"
#include "fluid_partner.h"
#include "limits.h"
#include "objects/spring_forces.h"
#include "objects/spring_law.h"
#include "options.h"
#include "worst_object.h"

namespace LAMMPS_NS {

class FixObjects;
class FixPropertyAtom;

class FixMassSpring : public Fix, public swellflow::KnowsFigures {
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
  void add_limits(std::vector<swellflow::Figure> &) override;
  void add_accuracy(std::vector<swellflow::Figure> &figures) override { add_limits(figures); }

  bool acts_on(const swellflow::ObjectPoints &object) const;
  /// Angular frequency with which the object's size swings about the natural one; 0 where its springs do not move it, or ask for no size.
  double breathing_frequency(const swellflow::ObjectPoints &object) const;
  /// The object's springs as they are now; what it returns is overwritten by the next call.
  const swellflow::SpringSet &springs_of(const swellflow::ObjectPoints &object) const;
  double energy_of(const swellflow::ObjectPoints &object) const;
  /// Adds what this fix has put into atom->f of own points in this step, x and y; nothing for objects whose integrator solves the springs itself.
  void add_given(double *own_xy) const;

 private:
  struct Totals {
    double energy = 0.0, largest_strain = 0.0, dissipated_power = 0.0;
  };
  void parse(int narg, char **arg);
  void read_stiffening(swellflow::Arguments &line);
  void find_integrators();
  bool gives_forces_to(const swellflow::ObjectPoints &object) const;
  const swellflow::SpringSet &natural_springs(const swellflow::ObjectPoints &object) const;
  void find_natural_springs(const swellflow::ObjectPoints &object, swellflow::SpringSet &springs) const;
  swellflow::SpringScale scale_of(const swellflow::ObjectPoints &object) const;
  template <typename F>
  void for_each_force(bool with_dashpots, const F &f) const;
  void add_forces(bool with_dashpots);
  void forget_dashpots_of_solved_objects();
  bool damped() const { return law_.damping > 0.0; }
  std::string dashpot_property() const { return std::string("spring_dashpot_") + id; }
  const Totals &totals();
  std::vector<double> velocities() const;

  bool moves_explicitly(const swellflow::ObjectPoints &object) const;
  WorstObject step_over_limit(double floor) const;
  swellflow::Figure figure_of(const WorstObject &limit) const;
  void judge_step() const;

  swellflow::SpringLaw law_;
  double restitution_;
  FixObjects *objects_;
  FixPropertyAtom *dashpot_;  // force of the dashpots on each point, at dashpot_step_; null without damping
  bigint dashpot_step_;       // -1: none yet
  int solved_groups_, explicit_groups_;  // bits of the groups whose integrators solve springs, or take them as forces
  Totals totals_;
  bigint totals_step_;  // of totals_; -1: none
  mutable swellflow::SpringSet springs_;
  mutable swellflow::SpringForces forces_;
  mutable std::vector<swellflow::SpringSet> natural_;  // of objects(), by their place in that list
  mutable int natural_of_list_;                        // number of the list; -1: none
};

}  // namespace LAMMPS_NS
