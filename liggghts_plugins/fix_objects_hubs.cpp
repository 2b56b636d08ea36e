// Hubs that no spoke holds: they follow their ring.
#include "atom.h"
#include "comm.h"
#include "error.h"
#include "fix_checkpoint.h"
#include "fix_objects.h"
#include "objects/vector2.h"
#include "update.h"

using namespace LAMMPS_NS;
using swellflow::Vector2;

namespace {

/// Of two values a point, over the ring, relative to the first so that far from the origin no digits are lost.
Vector2 mean_over_ring(const swellflow::ObjectPoints &object, double **values)
{
  const double *first = values[object.ring[0]];
  Vector2 sum = Vector2::Zero();
  for (int k = 0; k < object.n_ring; k++) sum += Vector2(values[object.ring[k]][0] - first[0], values[object.ring[k]][1] - first[1]);
  return Vector2(first[0], first[1]) + sum / object.n_ring;
}

}  // namespace

bool FixObjects::follows_its_ring(int i) const
{
  const double *point = points()[i];
  return point[RING_POINTS] > 0.0 && point[INDEX] < 0.0 && point[SPOKES] == 0.0;
}

void FixObjects::require_ghost_velocities()
{
  int any = 0;
  for (int i = 0; i < atom->nlocal; i++) any |= follows_its_ring(i);
  MPI_Allreduce(MPI_IN_PLACE, &any, 1, MPI_INT, MPI_MAX, world);
  if (any && !comm->ghost_velocity)
    error->fix_error(FLERR, this, "a hub without spokes needs the velocities of its ring, but ghosts have none: add 'communicate single vel yes'");
}

/* ----------------------------------------------------------------------
   Ghosts are where their own atoms are. Own hubs, and the images of hubs
   that this rank reckons with.
------------------------------------------------------------------------- */

void FixObjects::setup_pre_force(int)
{
  const FixCheckpoint *checkpoint = find_checkpoint(lmp);
  if (!checkpoint || !checkpoint->continues()) hubs_follow();
}

/// Not twice: a hub next to a border between ranks must not cross it after points have gone to the ranks that own their places.
void FixObjects::pre_force(int)
{
  if (update->ntimestep != followed_at_) hubs_follow();
}

/// Before points go to other ranks. Own points have moved since ghosts were updated.
void FixObjects::hubs_follow_early()
{
  if (!some_follow_) return;
  comm->forward_comm();
  hubs_follow();
  followed_at_ = update->ntimestep;
}

void FixObjects::hubs_follow()
{
  if (!some_follow_) return;
  double **x = atom->x, **v = atom->v;
  for (const auto &object : objects_) {
    const int hub = object.hub;
    if (!follows_its_ring(hub)) continue;
    const Vector2 at = mean_over_ring(object, x), velocity = mean_over_ring(object, v);
    const int own = own_index(hub);
    for (int d = 0; d < 2; d++) {
      if (own >= 0 && own != hub) {
        x[own][d] += at[d] - x[hub][d];
        v[own][d] = velocity[d];
      }
      x[hub][d] = at[d];
      v[hub][d] = velocity[d];
    }
  }
}
