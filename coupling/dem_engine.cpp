#include "coupling/dem_engine.h"

#include <stdexcept>

#include "lammps.h"
#include "library.h"
#include "liggghts_plugins/fix_objects.h"
#include "liggghts_plugins/fluid_columns.h"
#include "liggghts_plugins/object_geometry.h"

namespace swellflow {

namespace {

template <class T> T global(void *lammps, const char *name) { return *static_cast<T *>(lammps_extract_global(lammps, name)); }

}  // namespace

void DemEngine::refresh()
{
  n_own_ = global<int>(lammps_, "nlocal");
  time_step_ = global<double>(lammps_, "dt");
  x = static_cast<double **>(lammps_extract_atom(lammps_, "x"));
  v = static_cast<double **>(lammps_extract_atom(lammps_, "v"));
  mass = static_cast<double *>(lammps_extract_atom(lammps_, "rmass"));
  objects_ = LAMMPS_NS::find_objects(static_cast<LAMMPS_NS::LAMMPS *>(lammps_));
  object_point = objects_ ? per_atom(LAMMPS_NS::FixObjects::PROPERTY) : nullptr;
  object_size = objects_ ? per_atom(LAMMPS_NS::FixObjects::SIZES) : nullptr;
  law = per_atom(FluidLaw::NAME);
  impulse = per_atom(FluidImpulse::NAME);
  ahead = per_atom(FluidAhead::NAME);
  home = per_atom(FluidHome::NAME);
  carried = per_atom(FluidCarried::NAME);
  state = per_atom(FluidState::NAME);
}

int DemEngine::own_of_image(int i) const { return objects_->own_index(i); }

double **DemEngine::per_atom(const char *id) const
{
  constexpr int of_atoms = 1, of_rows = 2;
  auto **rows = static_cast<double **>(lammps_extract_fix(lammps_, id, of_atoms, of_rows, 0, 0));
  if (rows == nullptr && n_own_ > 0) throw std::runtime_error(std::string("the per-atom vector '") + id + "' is gone; do not unfix it");
  return rows;
}

std::vector<Vector2> DemEngine::outline(const ObjectPoints &object) const
{
  return LAMMPS_NS::outline_of(static_cast<LAMMPS_NS::LAMMPS *>(lammps_), object);
}

MPI_Comm DemEngine::communicator() const { return static_cast<LAMMPS_NS::LAMMPS *>(lammps_)->world; }

std::array<double, 3> DemEngine::corner(const char *x, const char *y, const char *z) const
{
  return {global<double>(lammps_, x), global<double>(lammps_, y), global<double>(lammps_, z)};
}

}  // namespace swellflow
