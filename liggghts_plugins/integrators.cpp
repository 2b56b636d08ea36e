#include "integrators.h"

#include <algorithm>
#include <cstring>
#include <string>

#include "atom.h"
#include "error.h"
#include "fix.h"
#include "fix_object_integrator.h"
#include "fix_property_atom.h"
#include "fluid_columns.h"
#include "lammps.h"
#include "modify.h"

using namespace LAMMPS_NS;

bool LAMMPS_NS::knows_fluid_law(const Fix &fix)
{
  const char *styles[] = {"nve/cds", "rigid/cds", "held", "prescribed"};
  return std::any_of(std::begin(styles), std::end(styles), [&](const char *style) { return strcmp(fix.style, style) == 0; });
}

bool LAMMPS_NS::solves_springs(const Fix &fix) { return dynamic_cast<const FixObjectIntegrator *>(&fix) != nullptr; }

bool LAMMPS_NS::takes_springs_as_forces(const Fix &fix)
{
  return fix.time_integrate && strncmp(fix.style, "nve", 3) == 0 && !solves_springs(fix);
}

bool LAMMPS_NS::share_atoms(LAMMPS *lmp, const Fix &one, const Fix &other)
{
  const Atom *atom = lmp->atom;
  int both = 0;
  for (int i = 0; i < atom->nlocal; i++) both |= (atom->mask[i] & one.groupbit) && (atom->mask[i] & other.groupbit);
  MPI_Allreduce(MPI_IN_PLACE, &both, 1, MPI_INT, MPI_MAX, lmp->world);
  return both != 0;
}

void LAMMPS_NS::require_one_integrator(LAMMPS *lmp, const Fix &asking)
{
  for (int k = 0; k < lmp->modify->nfix; k++) {
    const Fix *other = lmp->modify->fix[k];
    if (other == &asking || !other->time_integrate) continue;
    if (strncmp(other->style, "nve", 3) != 0 && !knows_fluid_law(*other)) continue;
    if (!share_atoms(lmp, asking, *other)) continue;
    lmp->error->fix_error(FLERR, const_cast<Fix *>(&asking),
                          (std::string("a point must be moved by one integrator, but fix ") + other->id + " (" + other->style +
                           ") moves the same points: unfix one, or use groups that share none").c_str());
  }
}

double **LAMMPS_NS::fluid_columns(LAMMPS *lmp, const char *name)
{
  const int found = lmp->modify->find_fix(name);
  const auto *property = found < 0 ? nullptr : dynamic_cast<const FixPropertyAtom *>(lmp->modify->fix[found]);
  return property ? property->array_atom : nullptr;
}

void LAMMPS_NS::forget_what_is_ahead(LAMMPS *lmp, const Fix &asking)
{
  using swellflow::FluidAhead;
  double **ahead = fluid_columns(lmp, FluidAhead::NAME);
  for (int i = 0; ahead && i < lmp->atom->nlocal; i++)
    if (lmp->atom->mask[i] & asking.groupbit)
      for (int column : {FluidAhead::AHEAD_X, FluidAhead::AHEAD_Y, FluidAhead::KNOWS_AHEAD}) ahead[i][column] = 0.0;
}
