// Who touches whom, from the pair style's neighbour list.
#pragma once

#include <unordered_map>

#include "fluid_partner.h"

namespace LAMMPS_NS {

class LAMMPS;

/// Counts, for each object, the other objects and the atoms that are no points whose spheres touch its spheres: each partner once, however many spheres touch and
/// whichever ranks they are on. Walls are not atoms and are not counted.
class ContactPartners {
 public:
  /// Collective; between two reneighbourings.
  explicit ContactPartners(LAMMPS *lmp);
  /// Of an object whose hub this rank owns.
  int of(const swellflow::ObjectPoints &object) const;

 private:
  LAMMPS *lmp_;
  std::unordered_map<int, int> number_;  // by the hub's tag; who has no partner is not there
};

}  // namespace LAMMPS_NS
