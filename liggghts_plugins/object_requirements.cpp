// What must hold before there can be objects, and what users are told when it does not.
#include <algorithm>

#include "atom.h"
#include "domain.h"
#include "error.h"
#include "fix_objects.h"
#include "modify.h"

using namespace LAMMPS_NS;

/* ----------------------------------------------------------------------
   what LIGGGHTS must have been told before there can be objects
------------------------------------------------------------------------- */

std::string LAMMPS_NS::why_no_objects(LAMMPS *lmp)
{
  const Atom *atom = lmp->atom;
  if (!lmp->domain->box_exist) return "the simulation box must exist first: add 'create_box' or 'read_restart' above";
  if (lmp->domain->dimension != 2)
    return "the dimension must be 2, but is " + std::to_string(lmp->domain->dimension) + ": add 'dimension 2'";
  if (lmp->domain->triclinic) return "the box must be rectangular, but is triclinic: use 'region block' without 'prism'";
  if (!atom->molecule_flag || !atom->radius_flag || !atom->rmass_flag)
    return std::string("points need a molecule id, a radius and a mass of their own, but the atom style is '") + atom->atom_style +
           "': use 'atom_style hybrid granular molecular'";
  if (atom->map_style == 0) return "points find their partners through an atom map, but there is none: add 'atom_modify map array'";
  return "";
}

FixObjects *LAMMPS_NS::make_objects(LAMMPS *lmp)
{
  if (FixObjects *existing = find_objects(lmp)) return existing;
  const char *arguments[] = {FixObjects::ID, "all", "objects"};
  lmp->modify->add_fix(3, const_cast<char **>(arguments));
  return find_objects(lmp);
}

FixObjects *LAMMPS_NS::require_objects(LAMMPS *lmp, const Fix &asking)
{
  std::string problem = why_no_objects(lmp);
  FixObjects *objects = nullptr;
  if (problem.empty()) {
    objects = make_objects(lmp);
    int points = 0;
    for (int i = 0; i < lmp->atom->nlocal; i++) points += objects->is_point(i);
    MPI_Allreduce(MPI_IN_PLACE, &points, 1, MPI_INT, MPI_SUM, lmp->world);
    if (points == 0)
      problem = "there must be objects, but there are none: put 'create_objects' above it, or after a read_restart put it before the first run";
  }
  if (!problem.empty()) lmp->error->fix_error(FLERR, const_cast<Fix *>(&asking), problem.c_str());
  return objects;
}

/* ---------------------------------------------------------------------- */

void FixObjects::require_whole_objects(const Fix &asking) const
{
  int torn = 0;
  for (const auto &object : objects_) {
    int members = (atom->mask[object.hub] & asking.groupbit) != 0;
    for (int k = 0; k < object.n_ring; k++) members += (atom->mask[object.ring[k]] & asking.groupbit) != 0;
    if (members > 0 && members < object.n_ring + 1) torn = std::max(torn, atom->molecule[object.hub]);
  }
  int torn_anywhere = 0;
  MPI_Allreduce(&torn, &torn_anywhere, 1, MPI_INT, MPI_MAX, world);
  if (torn_anywhere) {
    const std::string message = "the group must hold all points of an object or none, but holds some of object (molecule) " +
                                std::to_string(torn_anywhere) + ": make the group from molecule ids";
    error->fix_error(FLERR, const_cast<Fix *>(&asking), message.c_str());
  }
}
