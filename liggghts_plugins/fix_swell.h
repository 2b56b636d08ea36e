// Growth of the natural size of objects: natural lengths, CDS radii and masses as functions of time.
#pragma once

#include <vector>

#include "fix.h"
#include "fluid_partner.h"
#include "limits.h"
#include "objects/swelling_pace.h"
#include "swell_script.h"

namespace LAMMPS_NS {

class FixFluidScalar;
class FixObjects;

class FixSwell : public Fix, public swellflow::KnowsFigures {
 public:
  FixSwell(class LAMMPS *, int, char **);

  int setmask() override;
  void post_create() override;
  void pre_delete(bool unfixflag) override;
  void init() override;
  void setup_pre_force(int) override;
  void setup(int) override;
  void pre_initial_integrate() override;
  void post_integrate() override;
  void pre_force(int) override;
  void end_of_step() override;
  void post_run() override;
  void reset_dt() override;
  void reset_timestep(bigint) override {}
  void reset_timestep(bigint new_step, bigint old_step) override;
  void write_restart(FILE *) override;
  void restart(char *) override;
  double compute_scalar() override;
  double compute_vector(int) override;
  void add_limits(std::vector<swellflow::Figure> &figures) override;
  void add_accuracy(std::vector<swellflow::Figure> &figures) override;

  /// Whether growing objects drink the fluid (true) or push it away. Which objects: those of this fix's group.
  bool absorbs() const { return script_.absorb; }

 private:
  static constexpr int N_VALUES = 11, N_SIZES = 9;  // the last two are of its pace

  enum Sum { COUNT, NATURAL, HUB_DISTANCE, OF_AREA, ASPECT_RATIO, AREA, ELAPSED, N_SUMS };
  enum Extreme { MINUS_AREA_RATIO, LAMBDA_MAX, N_EXTREMES };  // of which the largest counts

  bool is_ours(int i) const;
  double time() const;
  double elapsed(const double *point, double time) const;

  // fix_swell_checks.cpp
  void require_one_law_per_object();
  void find_food();
  void forget_starts();
  void start_law();
  void require_starts();
  double scattered(const double *point, double law_diameter) const;
  double law_diameter_for(const double *point, double natural_diameter) const;
  double smallest_allowed(const double *point) const;
  void require_sizes();
  void find_least_variable();
  void fail_size(int object, double diameter, double time);

  // growth
  struct Natural { double lambda, mass; bool settled; };
  Natural natural(const double *point, double time) const;
  double water_ratio(const double *point) const;
  double mass_ratio(const double *point, double lambda) const;
  void evaluate_variable();
  bool grow(int from, int to, bool all);
  bool settled() const;

  // the objects' own clocks, under load and by what they feed on
  double speed(double pressure) const;
  double speed_by_food(int own) const;
  void measure_speeds();
  void tell_ghosts_their_starts();

  // fix_swell_pace.cpp
  double growth_rate(const swellflow::ObjectPoints &object) const;
  void add_pace(swellflow::SwellingPace &pace) const;
  swellflow::SwellingPace of_all_ranks(const swellflow::SwellingPace &own) const;
  const swellflow::SwellingPace &pace_now();
  void look_at_pace();

  // fix_swell_limits.cpp
  double fastest_growth(const double *point, double span) const;
  bool is_rigid(const swellflow::ObjectPoints &object) const;
  double smallest_sphere(const swellflow::ObjectPoints &object) const;
  double growth_beyond_springs(const swellflow::ObjectPoints &object) const;
  double inner_diameter_at_end(const swellflow::ObjectPoints &object) const;

  // fix_swell_values.cpp
  void add_object(const swellflow::ObjectPoints &object, double *sums, double *extremes) const;
  const double *values();

  swellflow::SwellScript script_;
  double variable_value_, variable_before_; // of this step and the last
  double least_variable_;                   // which it must be above, or an object would vanish:
  int least_object_;
  swellflow::SwellingClock clock_;
  bool restored_;
  bigint own_settled_at_, settled_at_;      // the neighbour lists for which nothing grows any more; -1: none
  std::vector<double> speeds_;              // that load leaves the objects' clocks, at the hubs: from the end of a step to the start of the next
  std::vector<double> sent_;                // one value an atom, for ghosts
  FixObjects *objects_;
  const FixFluidScalar *food_ = nullptr;
  double values_[N_SIZES];
  bigint values_step_;                      // of values_; -1: none
  swellflow::SwellingPace pace_now_, pace_of_run_;
  bigint pace_step_ = -1;                   // of pace_now_; -1: none
  bool warned_ = false;
};

}  // namespace LAMMPS_NS
