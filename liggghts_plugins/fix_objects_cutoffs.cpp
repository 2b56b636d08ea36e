// Cut-offs, neighbour lists and ghosts that reach far enough for objects that grow and stretch.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>
#include <unordered_map>

#include "all_ranks.h"
#include "atom.h"
#include "comm.h"
#include "compute.h"
#include "domain.h"
#include "error.h"
#include "fix_checkpoint.h"
#include "fix_objects.h"
#include "force.h"
#include "guard.h"
#include "modify.h"
#include "neigh_request.h"
#include "neighbor.h"
#include "options.h"
#include "pair.h"
#include "update.h"

using namespace LAMMPS_NS;

namespace {

// A cap above the radius, and a reach above the extent, spares a new set-up at each reneighbouring of a growing object.
constexpr double headroom = 1.05;
constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace

double FixObjects::max_rad(int type) { return radius_cap_[type]; }

/* ----------------------------------------------------------------------
   what one rank knows of an object
------------------------------------------------------------------------- */

struct FixObjects::Part {
  int hub_tag, molecule, missing_points;
  bool finite = true;
  double low[2] = {infinity, infinity}, high[2] = {-infinity, -infinity};

  Extents extents(double reach) const
  {
    const double x = high[0] - low[0], y = high[1] - low[1];
    if (!finite) return {{{infinity, molecule}, {infinity, molecule}, {infinity, molecule}}};
    return {{{x, molecule}, {y, molecule}, {reach, molecule}}};
  }
  Extents extents() const { return extents(std::hypot(high[0] - low[0], high[1] - low[1])); }
};

bool FixObjects::is_finite(int i) const
{
  const double *x = atom->x[i], *v = atom->v[i];
  return std::isfinite(x[0] + x[1] + x[2]) && (i >= atom->nlocal || std::isfinite(v[0] + v[1] + v[2]));
}

void FixObjects::add_point(Part &part, int i, const double *x) const
{
  part.missing_points--;
  part.finite = part.finite && is_finite(i);
  for (int d = 0; d < 2; d++) {
    part.low[d] = std::min(part.low[d], x[d]);
    part.high[d] = std::max(part.high[d], x[d]);
  }
}

void FixObjects::merge(Part &whole, const Part &part)
{
  whole.finite = whole.finite && part.finite;
  for (int d = 0; d < 2; d++) {
    whole.low[d] = std::min(whole.low[d], part.low[d]);
    whole.high[d] = std::max(whole.high[d], part.high[d]);
  }
}

void FixObjects::include(Extents &largest, const Extents &other)
{
  for (int k = 0; k < N_MEASURES; k++) largest[k].meet(other[k].value, other[k].object);
}

/* ----------------------------------------------------------------------
   during a run: of every object with an own point. Own points have moved
   since ghosts were updated.
------------------------------------------------------------------------- */

FixObjects::Extents FixObjects::extents_of_own_objects() const
{
  Extents largest{};
  for (const auto &object : objects_) {
    const double *hub = atom->x[object.hub];
    Part part{.hub_tag = atom->tag[object.hub], .molecule = atom->molecule[object.hub], .missing_points = object.n_ring + 1};
    add_point(part, object.hub, hub);
    double farthest = 0.0;
    for (int k = 0; k < object.n_ring; k++) {
      const double *point = atom->x[object.ring[k]];
      add_point(part, object.ring[k], point);
      farthest = std::max(farthest, std::hypot(point[0] - hub[0], point[1] - hub[1]));
    }
    include(largest, part.extents(2.0 * farthest));
  }
  return largest;
}

/* ----------------------------------------------------------------------
   before a run there are no ghosts: objects that have points on several
   ranks are put together from their parts, on all ranks
------------------------------------------------------------------------- */

std::vector<FixObjects::Part> FixObjects::unwrapped_parts() const
{
  std::vector<Part> parts;
  std::unordered_map<int, std::size_t> part_of;  // by the hub's tag
  for (int i = 0; i < atom->nlocal; i++) {
    if (!is_point(i)) continue;
    const auto [found, is_new] = part_of.try_emplace(tag_of_hub(i), parts.size());
    if (is_new)
      parts.push_back({.hub_tag = found->first, .molecule = atom->molecule[i], .missing_points = static_cast<int>(points()[i][RING_POINTS]) + 1});
    double x[3];
    domain->unmap(atom->x[i], atom->image[i], x);
    add_point(parts[found->second], i, x);
  }
  return parts;
}

FixObjects::Extents FixObjects::extents_of_unwrapped_objects() const
{
  Extents largest{};
  std::vector<Part> torn;
  for (const Part &part : unwrapped_parts()) {
    if (part.missing_points > 0) torn.push_back(part);
    else include(largest, part.extents());
  }
  std::unordered_map<int, Part> wholes;
  for (const Part &part : from_all_ranks(torn, world)) merge(wholes.try_emplace(part.hub_tag, part).first->second, part);
  for (const auto &[tag, whole] : wholes) include(largest, whole.extents());
  return largest;
}

/* ----------------------------------------------------------------------
   The extents of all ranks' objects, or the end: what has run away would
   make ghosts without end.
------------------------------------------------------------------------- */

double FixObjects::widest_allowed(int d) const
{
  const bool fixed = domain->boundary[d][0] == 1 && domain->boundary[d][1] == 1;
  // Sides that follow the atoms do so at a reneighbouring only.
  return domain->prd[d] * (domain->periodicity[d] ? 0.5 : fixed ? 1.0 : 2.0);
}

void FixObjects::fail_not_finite(int object)
{
  end_run(lmp, *this, "points must have finite positions and velocities, but " + name_of(object) + " has one that is infinite or not a number at step " +
                        std::to_string(update->ntimestep) + ": use a shorter time step or softer springs");
}

void FixObjects::require_sane(Extents &largest)
{
  agree_on_worst(world, largest);
  if (std::isinf(largest[REACH].value)) fail_not_finite(largest[REACH].object);
  for (int d = 0; d < 2; d++) {
    const WorstObject &across = largest[d == 0 ? ACROSS_X : ACROSS_Y];
    if (across.value < widest_allowed(d)) continue;
    const std::string message = std::string("an object must be smaller than ") + (domain->periodicity[d] ? "half a periodic box" : "the box") +
                                ", but " + name_of(across.object) + " is " + swellflow::rounded(across.value) +
                                " wide in " + "xy"[d] + " in a box of " + swellflow::rounded(domain->prd[d]) + " at step " +
                                std::to_string(update->ntimestep) + ": use a shorter time step or softer springs, or make the box larger";
    end_run(lmp, *this, message);
  }
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
  counts_ = own_counts();
  MPI_Allreduce(MPI_IN_PLACE, counts_.data(), N_COUNTS, MPI_LMP_BIGINT, MPI_SUM, world);
  Extents largest = extents_of_unwrapped_objects();
  require_sane(largest);
  // A run that goes on has had its cut-offs for this step; here they are measured in another way.
  const FixCheckpoint *checkpoint = find_checkpoint(lmp);
  if (!checkpoint || !checkpoint->continues()) widen_cutoffs(largest[REACH].value);
}

/* ----------------------------------------------------------------------
   Bins, and with them the order in which contacts are summed up, follow
   from cut-offs that were widened in the past
------------------------------------------------------------------------- */

void FixObjects::write_restart(FILE *fp)
{
  if (comm->me != 0) return;
  std::vector<double> state = {static_cast<double>(radius_cap_.size()), ghost_reach_};
  state.insert(state.end(), radius_cap_.begin(), radius_cap_.end());
  const int size = static_cast<int>(state.size() * sizeof(double));
  fwrite(&size, sizeof size, 1, fp);
  fwrite(state.data(), sizeof(double), state.size(), fp);
}

void FixObjects::restart(char *buffer)
{
  const auto *state = reinterpret_cast<const double *>(buffer);
  if (static_cast<std::size_t>(state[0]) != radius_cap_.size()) return;
  ghost_reach_ = state[1];
  std::copy_n(state + 2, radius_cap_.size(), radius_cap_.begin());
}

void FixObjects::pre_exchange()
{
  hubs_follow_early();
  Extents largest = extents_of_own_objects();
  require_sane(largest);
  if (!widen_cutoffs(largest[REACH].value)) return;
  // A mesh at rest sends its elements to neighbouring ranks at the start of a run only, as far as the cut-off was then.
  for (int i = 0; i < modify->nfix; i++)
    if (strncmp(modify->fix[i]->style, "mesh/", 5) == 0) modify->fix[i]->setup_pre_force(0);
}
