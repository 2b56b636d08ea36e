// A scalar that the fluid carries, and objects that feel it and take it up. The fix parses and keeps what belongs to the objects; the fluid's partner moves the scalar.
#pragma once

#include <memory>
#include <vector>

#include "fix.h"
#include "fluid_partner.h"
#include "scalar_script.h"

namespace LAMMPS_NS {

class FixFluidIb;
class FixObjects;
class FixPropertyAtom;

class FixFluidScalar : public Fix {
 public:
  FixFluidScalar(class LAMMPS *, int, char **);

  int setmask() override;
  void post_create() override;
  void pre_delete(bool unfixflag) override;
  void init() override;
  void setup(int) override;
  void end_of_step() override;
  double compute_scalar() override;
  double compute_vector(int n) override;

  /// At the outline of the object of own point i, in the mean, after the last fluid step.
  double concentration(int i) const { return points()[i][CONCENTRATION]; }
  /// What the object has taken up so far; i: its hub, an own point.
  double uptake(int i) const { return points()[i][UPTAKE]; }

 private:
  /// Of each point: the first two; of the hub alone, where its owner keeps them: the others.
  enum Column {
    CONCENTRATION,
    UPTAKE,
    KNOWN,   // whether the others are: not before the first run in which the object meets the scalar
    AREA,    // that has been drunk, as far as uptake goes: that of the outline on its way to the natural one
    OWED,    // what is still to be taken
    AROUND,  // sum of value times spacing over the markers, when the scalar was met last
    N_COLUMNS
  };
  enum Sum { OBJECTS, CONCENTRATIONS, STILL_OWED, N_SUMS };

  double **points() const;  ///< moves when atoms migrate
  const char *property() const { return property_.c_str(); }
  bool drinks(const swellflow::ObjectPoints &object) const;
  void require_place();
  void make_scalar();
  void meet_new_objects();
  void meet(const swellflow::ObjectPoints &object, double concentration);
  void ask_for_uptake();
  void thirst(const swellflow::ObjectPoints &object);
  void take_in();
  const double *values();

  swellflow::ScalarScript script_;
  std::string property_;
  FixPropertyAtom *state_ = nullptr;
  FixFluidIb *fluid_ = nullptr;
  FixObjects *objects_ = nullptr;
  swellflow::ScalarPartner *scalar_ = nullptr;
  bigint followed_ = 0;                      // whole fluid steps
  std::vector<double> rates_, sent_;         // by atom, ghosts too
  std::vector<swellflow::ScalarMet> met_;
  static constexpr int N_VALUES = 12;
  double values_[N_VALUES] = {};
  bigint values_step_ = -1;
};

}  // namespace LAMMPS_NS
