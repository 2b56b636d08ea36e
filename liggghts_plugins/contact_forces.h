// What other objects and walls do to the points of objects: all forces on a point but those that are known to be something else.
#pragma once

#include <vector>

#include "fluid_partner.h"
#include "objects/vector2.h"

namespace LAMMPS_NS {

class Fix;
class LAMMPS;

/// The forces of one moment. Without a pair style there are no contacts: all are zero, at no cost.
class ContactForces {
 public:
  /// Collective; at the end of a step, or in setup, where atom->f must be whole (require_whole_forces).
  explicit ContactForces(LAMMPS *lmp);

  /// On an own point or a ghost: atom->f less weight (fix gravity), springs and unresolved lubrication; exactly zero without contact. What the fluid gives is not in atom->f.
  swellflow::Vector2 on(int i) const;
  /// -sum F.(x - c) / (2 A), c the centre of mass, A the area in the outline: the mean stress that forces F at x give a body at rest, its trace halved
  /// (Christoffersen, Mehrabadi & Nemat-Nasser, J. Appl. Mech. 48, 339, 1981). > 0 when the object is squeezed.
  double pressure(const swellflow::ObjectPoints &object) const;

 private:
  std::vector<double> weights() const;

  LAMMPS *lmp_;
  std::vector<double> forces_;  // two values an atom, own and ghosts; empty without contacts
};

/// A LIGGGHTS error, with a remedy, when a fix that makes forces comes after one that reads them when a run begins. To be called in init().
void require_whole_forces(LAMMPS *lmp, const Fix &asking);

}  // namespace LAMMPS_NS
