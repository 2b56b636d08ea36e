// LIGGGHTS' points as the coupling sees them, through the library interface.
#pragma once

#include <mpi.h>

#include <array>
#include <string>
#include <vector>

#include "liggghts_plugins/fluid_partner.h"
#include "liggghts_plugins/objects/vector2.h"

namespace LAMMPS_NS {
class FixObjects;
}

namespace swellflow {

/// Pointers into LIGGGHTS' own memory: it moves when atoms migrate, so `refresh` before each use. What is not an array is as it was then, too.
class DemEngine {
public:
  explicit DemEngine(void *lammps) : lammps_(lammps) {}

  /// Throws std::runtime_error when a per-atom vector is not there.
  void refresh();

  int n_own() const { return n_own_; }
  /// The own point that i, an own point or a ghost of whatever image, stands for; -1 when another rank owns it.
  int own_index(int i) const { return i < n_own_ ? i : own_of_image(i); }
  /// The vertices of an object's outline relative to its hub.
  std::vector<Vector2> outline(const ObjectPoints &object) const;
  double time_step() const { return time_step_; }
  MPI_Comm communicator() const;
  std::array<double, 3> box_low() const { return corner("boxxlo", "boxylo", "boxzlo"); }
  std::array<double, 3> box_high() const { return corner("boxxhi", "boxyhi", "boxzhi"); }

  // Own points and ghosts, but for the last line: own points only.
  double **x = nullptr, **v = nullptr, *mass = nullptr;
  double **object_point = nullptr, **object_size = nullptr;  ///< columns: FixObjects::Column, SizeColumn; null in a scene without objects
  double **carried = nullptr, **law = nullptr, **ahead = nullptr;  ///< columns: FluidCarried, FluidLaw, FluidAhead
  double **impulse = nullptr, **home = nullptr, **state = nullptr;  ///< columns: FluidImpulse, FluidHome, FluidState

private:
  int own_of_image(int i) const;
  double **per_atom(const char *id) const;
  std::array<double, 3> corner(const char *x, const char *y, const char *z) const;

  void *lammps_;
  const LAMMPS_NS::FixObjects *objects_ = nullptr;
  int n_own_ = 0;
  double time_step_ = 0.0;
};

}  // namespace swellflow
