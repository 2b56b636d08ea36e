// Cut-offs, neighbour lists and ghosts that reach far enough for objects that grow and stretch.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>

#include "atom.h"
#include "comm.h"
#include "compute.h"
#include "domain.h"
#include "error.h"
#include "fix_objects.h"
#include "force.h"
#include "modify.h"
#include "neigh_request.h"
#include "neighbor.h"
#include "options.h"
#include "pair.h"

using namespace LAMMPS_NS;

namespace {

// A cap above the radius, and a reach above the extent, spares a new set-up at each reneighbouring of a growing object.
constexpr double headroom = 1.05;

}  // namespace

double FixObjects::max_rad(int type) { return radius_cap_[type]; }

double FixObjects::widest_own_object() const
{
  double farthest = 0.0;
  for (const auto &object : objects_) {
    if (!owns(object)) continue;
    const double *hub = atom->x[object.hub];
    for (int k = 0; k < object.n_ring; k++) {
      const double *point = atom->x[object.ring[k]];
      farthest = std::max(farthest, std::hypot(point[0] - hub[0], point[1] - hub[1]));
    }
  }
  return 2.0 * farthest;
}

/* ----------------------------------------------------------------------
   before a run there are no ghosts: the extents come from all ranks
------------------------------------------------------------------------- */

double FixObjects::widest_unwrapped_object() const
{
  int largest_id = 0;
  for (int i = 0; i < atom->nlocal; i++)
    if (is_point(i)) largest_id = std::max(largest_id, atom->molecule[i]);
  MPI_Allreduce(MPI_IN_PLACE, &largest_id, 1, MPI_INT, MPI_MAX, world);

  std::vector<double> high(4 * (largest_id + 1), -1e300);  // of x, -x, y, -y
  for (int i = 0; i < atom->nlocal; i++) {
    if (!is_point(i)) continue;
    double x[3];
    domain->unmap(atom->x[i], atom->image[i], x);
    double *extent = &high[4 * atom->molecule[i]];
    for (int d = 0; d < 2; d++) {
      extent[2 * d] = std::max(extent[2 * d], x[d]);
      extent[2 * d + 1] = std::max(extent[2 * d + 1], -x[d]);
    }
  }
  MPI_Allreduce(MPI_IN_PLACE, high.data(), high.size(), MPI_DOUBLE, MPI_MAX, world);
  double widest = 0.0;
  for (std::size_t k = 0; k < high.size(); k += 4)
    if (high[k] > -1e300) widest = std::max(widest, std::hypot(high[k] + high[k + 1], high[k + 2] + high[k + 3]));
  return widest;
}

bool FixObjects::raise_radius_caps()
{
  if (!atom->radvary_flag) return false;
  std::vector<double> largest(atom->ntypes + 1, 0.0);
  for (int i = 0; i < atom->nlocal; i++)
    if (is_point(i)) largest[atom->type[i]] = std::max(largest[atom->type[i]], atom->radius[i]);
  MPI_Allreduce(MPI_IN_PLACE, largest.data(), largest.size(), MPI_DOUBLE, MPI_MAX, world);
  bool raised = false;
  for (int type = 1; type <= atom->ntypes; type++)
    if (largest[type] > radius_cap_[type]) {
      radius_cap_[type] = headroom * largest[type];
      raised = true;
    }
  return raised;
}

/* ----------------------------------------------------------------------
   new neighbour lists drop those that nobody asks for: fixes and computes
   must ask again, in the order of the first time, not the pair style only
------------------------------------------------------------------------- */

void FixObjects::renew_neighbor_lists()
{
  if (force->pair) force->pair->init();
  std::vector<void *> asked;
  for (int i = 0; i < neighbor->old_nrequest; i++) {
    const NeighRequest *request = neighbor->old_requests[i];
    if (std::find(asked.begin(), asked.end(), request->requestor) != asked.end()) continue;
    asked.push_back(request->requestor);
    if (request->fix) static_cast<Fix *>(request->requestor)->init();
    if (request->compute) static_cast<Compute *>(request->requestor)->init();
  }
  neighbor->init();
}

/* ----------------------------------------------------------------------
   LIGGGHTS takes its cut-offs from the radii at the start of a run. When
   they are outgrown, pair style, neighbour lists and communication are
   set up again, which keeps contact histories.
------------------------------------------------------------------------- */

bool FixObjects::widen_cutoffs(double widest_object)
{
  const bool outgrown = raise_radius_caps();
  const bool too_short = widest_object > ghost_reach_;
  if (too_short) ghost_reach_ = headroom * widest_object;
  if (outgrown) renew_neighbor_lists();
  if (outgrown || too_short) {
    comm->setup();
    if (neighbor->style) neighbor->setup_bins();
  }
  return outgrown;
}

void FixObjects::setup_pre_exchange()
{
  require_exclusion();
  const double widest = widest_unwrapped_object();
  for (int d = 0; d < 2; d++)
    if (domain->periodicity[d] && widest >= 0.5 * domain->prd[d]) {
      const std::string message = "an object must be smaller than half a periodic box, but the widest is " + swellflow::shown(widest) +
                                  " in a box of " + swellflow::shown(domain->prd[d]) + ": make the box larger";
      error->fix_error(FLERR, this, message.c_str());
    }
  widen_cutoffs(widest);
}

void FixObjects::pre_exchange()
{
  double widest = widest_own_object();
  MPI_Allreduce(MPI_IN_PLACE, &widest, 1, MPI_DOUBLE, MPI_MAX, world);
  if (!widen_cutoffs(widest)) return;
  // A mesh at rest sends its elements to neighbouring ranks at the start of a run only, as far as the cut-off was then.
  for (int i = 0; i < modify->nfix; i++)
    if (strncmp(modify->fix[i]->style, "mesh/", 5) == 0) modify->fix[i]->setup_pre_force(0);
}
