// Which spheres LIGGGHTS must not look for contacts of.
#include <string>
#include <vector>

#include "atom.h"
#include "error.h"
#include "fix_objects.h"
#include "force.h"
#include "group.h"
#include "neigh_list.h"
#include "neighbor.h"
#include "pair.h"

using namespace LAMMPS_NS;

/* ----------------------------------------------------------------------
   Neighbour lists never hold points without a sphere. LIGGGHTS can leave
   out groups; it forgets that over a restart, but not what the points are.
------------------------------------------------------------------------- */

void FixObjects::exclude_points_without_spheres()
{
  std::vector<int> without(atom->nlocal + 1);
  int any = 0;
  for (int i = 0; i < atom->nlocal; i++) any |= without[i] = is_point(i) && points()[i][HAS_CDS] == 0.0;
  MPI_Allreduce(MPI_IN_PLACE, &any, 1, MPI_INT, MPI_MAX, world);
  if (any) group->create(GROUP_WITHOUT_CDS, without.data());
  if (!any || excludes_) return;
  const char *words[] = {"exclude", "group", GROUP_WITHOUT_CDS, "all"};
  neighbor->modify_params(4, const_cast<char **>(words));
  excludes_ = true;
}

/* ----------------------------------------------------------------------
   Neighbouring spheres of a ring overlap by design. Looked up in the list
   itself, because there are many ways to exclude pairs.
------------------------------------------------------------------------- */

bool FixObjects::overlap_by_design(int i, int j) const
{
  if (!is_point(i) || !is_point(j) || tag_of_hub(i) != tag_of_hub(j)) return false;
  const double *a = points()[i], *b = points()[j], reach = sizes()[i][CDS_RADIUS] + sizes()[j][CDS_RADIUS];
  const double x = a[REST_X] - b[REST_X], y = a[REST_Y] - b[REST_Y];
  return x * x + y * y < reach * reach;
}

void FixObjects::require_exclusions()
{
  const NeighList *list = force->pair ? force->pair->list : nullptr;
  int found[2] = {0, 0};  // spheres of one object, points without a sphere
  for (int n = 0; list && n < list->inum; n++) {
    const int i = list->ilist[n];
    for (int k = 0; k < list->numneigh[i]; k++) {
      const int j = list->firstneigh[i][k] & NEIGHMASK;
      found[0] |= overlap_by_design(i, j);
      for (const int point : {i, j}) found[1] |= is_point(point) && points()[point][HAS_CDS] == 0.0;
    }
  }
  MPI_Allreduce(MPI_IN_PLACE, found, 2, MPI_INT, MPI_MAX, world);
  if (found[0])
    error->fix_error(FLERR, this, "spheres of one object must not push each other apart, but they overlap and no pairs are excluded: "
                                  "add 'neigh_modify exclude molecule all'");
  if (found[1])
    error->fix_error(FLERR, this, (std::string("points without a sphere must have no neighbours, but they have: put 'neigh_modify exclude none' above "
                                               "'create_objects', or add 'neigh_modify exclude group ") + GROUP_WITHOUT_CDS + " all' below it").c_str());
}
