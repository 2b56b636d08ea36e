// A look at what all points are doing: whether numbers are numbers, outlines are the right way round, and speeds are such that a step can follow them.
#pragma once

#include <array>

#include "fluid_partner.h"
#include "pointers.h"
#include "worst_object.h"

namespace LAMMPS_NS {

class FixObjects;

class StateLook : protected Pointers {
 public:
  explicit StateLook(class LAMMPS *lmp) : Pointers(lmp) {}

  enum Kind {
    NOT_FINITE,  // 1 where an atom has a position, velocity or force that is infinite or not a number; the object is 0 for an atom that is no point
    INVERTED,    // area within an object's ring over its natural area, with the sign changed: >= 0 when it is turned inside out
    CRUSHED,     // area within an object's ring over its natural area, or that of the object as it was made where this is less, with the sign changed
    RUNAWAY,     // way of a point in `step` over the radius of its object, as it is or as it was made
    N_KINDS
  };
  using Findings = std::array<WorstObject, N_KINDS>;
  /// When a run begins: how small objects are. Collective.
  void begin();
  /// `step` [time]: what passes between two times at which a point can meet what is around it. Collective.
  Findings look(double step) const;

 private:
  int object_not_finite() const;
  void look_at_objects(const FixObjects &objects, Findings &worst) const;
  void look_at_speeds(const FixObjects &objects, double step, Findings &worst) const;

  double smallest_radius_ = 0.0;  // of an object as it was made
};

/// What the areas of outlines say of the fluid inside: objects that drink lose nothing, those that do not swell keep what they have. Those that inflate are left out.
class AreaBalance : protected Pointers {
 public:
  explicit AreaBalance(class LAMMPS *lmp) : Pointers(lmp) {}

  void begin();  ///< anew, with the next look
  void look();   ///< collective
  bool knows() const { return first_[KEEP] > 0.0 || first_[DRINK] > 0.0; }
  /// The largest that any look has seen, relative, of all objects together.
  double error() const { return error_; }

 private:
  enum Sum { KEEP, DRINK, DRINK_NATURAL, N_SUMS };
  using Sums = std::array<double, N_SUMS>;
  void add(const FixObjects &objects, const swellflow::ObjectPoints &object, Sum sum, Sums &sums) const;

  Sums first_{};
  double most_ = 0.0;  // that those which drink have had
  double error_ = 0.0;
};

}  // namespace LAMMPS_NS
