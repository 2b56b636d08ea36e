// Whether objects have passed into each other, to where contacts push them on.
#pragma once

#include <map>
#include <set>

#include "fluid_partner.h"
#include "pointers.h"
#include "worst_object.h"

namespace LAMMPS_NS {

class FixObjects;

class CrossingLook : protected Pointers {
 public:
  explicit CrossingLook(class LAMMPS *lmp) : Pointers(lmp) {}

  /// An object within whose ring the hub of another lies that touches it; none: 0. Collective.
  WorstObject look() const;

 private:
  using Touches = std::map<int, std::set<int>>;  // by tag of a hub, those of the hubs of others
  Touches touches(const FixObjects &objects) const;
  bool holds(const swellflow::ObjectPoints &object, int hub) const;
};

}  // namespace LAMMPS_NS
