// Growth of the natural size of objects: natural lengths, CDS radii and masses as functions of time.
#pragma once

#include <vector>

#include "fix.h"
#include "fluid_partner.h"
#include "objects/swelling_laws.h"
#include "script_value.h"

namespace LAMMPS_NS {

class FixObjects;

class FixSwell : public Fix {
 public:
  FixSwell(class LAMMPS *, int, char **);

  int setmask() override;
  void post_create() override;
  void pre_delete(bool unfixflag) override;
  void init() override;
  void setup_pre_force(int) override;
  void setup(int) override;
  void post_integrate() override;
  void pre_force(int) override;
  void reset_dt() override;
  void reset_timestep(bigint) override {}
  void reset_timestep(bigint new_step, bigint old_step) override;
  void write_restart(FILE *) override;
  void restart(char *) override;
  double compute_scalar() override;
  double compute_vector(int) override;

  /// Whether growing objects drink the fluid (true) or push it away. Which objects: those of this fix's group.
  bool absorbs() const { return absorb_; }

 private:
  enum Law { LINEAR, DIAMETER, RATIO };
  static constexpr int N_VALUES = 8;

  enum Sum { COUNT, NATURAL, HUB_DISTANCE, OF_AREA, ASPECT_RATIO, AREA, N_SUMS };
  enum Extreme { MINUS_AREA_RATIO, LAMBDA_MAX, N_EXTREMES };  // of which the largest counts

  void parse(int narg, char **arg);
  void check_law();
  void require_one_law_per_object();
  void start_law();
  double time() const;
  void evaluate_variable();
  double natural_lambda(const double *point, double time) const;
  void grow(int from, int to);
  void add_object(const swellflow::ObjectPoints &object, double *sums, double *extremes) const;
  const double *values();

  Law law_;
  bool absorb_;
  swellflow::LinearSwelling linear_;
  swellflow::ScriptValue size_;
  double variable_value_;
  swellflow::SwellingClock clock_;
  FixObjects *objects_;
  double values_[N_VALUES];
  bigint values_step_;  // of values_; -1: none
};

}  // namespace LAMMPS_NS
