#include "fix_objects.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "fix_property_atom.h"
#include "force.h"
#include "guard.h"
#include "modify.h"
#include "per_atom_values.h"
#include "progress_line.h"
#include "sort_bins.h"
#include "update.h"

using namespace LAMMPS_NS;
using namespace FixConst;

/* ---------------------------------------------------------------------- */

FixObjects::FixObjects(LAMMPS *lmp, int narg, char **arg) :
    Fix(lmp, narg, arg), property_(nullptr), sizes_(nullptr), counts_{}, ghost_reach_(0.0), progress_(new ProgressLine(lmp))
{
  if (strcmp(id, ID) != 0)
    error->fix_error(FLERR, this, "this fix is made by create_objects, under the id 'objects': remove it from the script");
  nevery = 1;
  comm_forward = 3;
  restart_global = 1;
  radius_cap_.assign(atom->ntypes + 1, 0.0);
}

FixObjects::~FixObjects() = default;

int FixObjects::setmask()
{
  return PRE_INITIAL_INTEGRATE | PRE_EXCHANGE | PRE_NEIGHBOR | PRE_FORCE | END_OF_STEP;
}

void FixObjects::post_create()
{
  const auto find_or_add = [this](const char *name, int columns) {
    const int found = modify->find_fix(name);
    if (found >= 0) return static_cast<FixPropertyAtom *>(modify->fix[found]);
    FixPropertyAtom *values = add_per_atom_values(lmp, name, columns, true);
    values->just_created = 0;  // LIGGGHTS would write the zeros again at the first run
    return values;
  };
  property_ = find_or_add(PROPERTY, N_COLUMNS);
  sizes_ = find_or_add(SIZES, N_SIZES);
}

void FixObjects::init()
{
  const auto known = [this](const char *name) {
    const int found = modify->find_fix(name);
    if (found < 0) error->fix_error(FLERR, this, (std::string("fix '") + name + "' holds what the objects are, but is gone: remove 'unfix " + name + "'").c_str());
    return static_cast<FixPropertyAtom *>(modify->fix[found]);
  };
  property_ = known(PROPERTY);
  sizes_ = known(SIZES);
  choose_sort_bins();
  exclude_points_without_spheres();
  require_ghost_velocities();
}

/* ----------------------------------------------------------------------
   LIGGGHTS sorts atoms by bins as small as a sphere, which takes points of
   an object apart in memory; within a bin they keep their order. With bins
   of some objects they stay together. Sizes as made: a run that goes on
   from a restart file chooses the same.
------------------------------------------------------------------------- */

void FixObjects::choose_sort_bins()
{
  // Without contacts there is no cut-off, and LIGGGHTS cannot choose bins at all.
  if (!force->pair) atom->sortfreq = 0;
  double &size = sort_bin_size(*atom);
  if (size != own_bin_size_) return;  // the script's bins, where it names some
  constexpr double objects_across = 8.0;
  double widest = 0.0;
  for (int i = 0; i < atom->nlocal; i++) widest = std::max(widest, points()[i][DIAMETER]);
  MPI_Allreduce(MPI_IN_PLACE, &widest, 1, MPI_DOUBLE, MPI_MAX, world);
  size = own_bin_size_ = objects_across * widest;
}

/* ---------------------------------------------------------------------- */

double **FixObjects::points() const { return property_->array_atom; }

double **FixObjects::sizes() const { return sizes_->array_atom; }

int FixObjects::own_index(int i) const
{
  if (i < atom->nlocal) return i;
  const int own = atom->map(atom->tag[i]);  // an own atom comes before its images
  return own < atom->nlocal ? own : -1;
}

bool FixObjects::owns(const swellflow::ObjectPoints &object) const { return own_index(object.hub) >= 0; }

int FixObjects::tag_of_hub(int i) const { return atom->tag[i] - 1 - static_cast<int>(points()[i][INDEX]); }

bool FixObjects::current() const
{
  for (const auto &object : objects_) {
    const int last = object.ring[object.n_ring - 1];
    if (std::max(object.hub, last) >= atom->nlocal + atom->nghost) return false;
    if (!is_point(object.hub) || points()[object.hub][INDEX] != -1.0) return false;
    if (atom->tag[last] != atom->tag[object.hub] + object.n_ring) return false;
  }
  return !objects_.empty();
}

bool FixObjects::current_everywhere() const
{
  const bool same_atoms = atom->nlocal == listed_atoms_ && atom->nghost == listed_ghosts_;
  int current_here = same_atoms && (objects_.empty() || current());
  MPI_Allreduce(MPI_IN_PLACE, &current_here, 1, MPI_INT, MPI_MIN, world);
  return current_here;
}

/* ----------------------------------------------------------------------
   the own point that stands for its object on this rank: the hub, or the
   first ring point where another rank owns the hub
------------------------------------------------------------------------- */

bool FixObjects::represents_its_object(int i) const
{
  const auto is_own = [this](int tag) { const int own = atom->map(tag); return own >= 0 && own < atom->nlocal; };
  const int index = static_cast<int>(points()[i][INDEX]), hub_tag = tag_of_hub(i);
  if (index < 0) return true;
  if (is_own(hub_tag)) return false;
  for (int k = 0; k < index; k++)
    if (is_own(hub_tag + 1 + k)) return false;
  return true;
}

/* ----------------------------------------------------------------------
   hub and ring of the object of own point i, as the images near it
------------------------------------------------------------------------- */

bool FixObjects::find_points(int i, int &hub, int *ring) const
{
  const int n = static_cast<int>(points()[i][RING_POINTS]), hub_tag = tag_of_hub(i);
  hub = domain->closest_image(i, atom->map(hub_tag));
  if (hub < 0) return false;
  for (int k = 0; k < n; k++) {
    ring[k] = domain->closest_image(hub, atom->map(hub_tag + 1 + k));
    if (ring[k] < 0) return false;
  }
  return true;
}

void FixObjects::list_objects()
{
  objects_.clear();
  list_number_++;
  ring_indices_.clear();
  listed_atoms_ = atom->nlocal;
  listed_ghosts_ = atom->nghost;
  std::vector<std::size_t> first_ring_point;
  int lost = 0;
  for (int i = 0; i < atom->nlocal; i++) {
    if (!is_point(i) || !represents_its_object(i)) continue;
    const int n = static_cast<int>(points()[i][RING_POINTS]);
    int hub = -1;
    ring_indices_.resize(ring_indices_.size() + n);
    first_ring_point.push_back(ring_indices_.size() - n);
    if (!find_points(i, hub, &ring_indices_[first_ring_point.back()])) lost = std::max(lost, atom->molecule[i]);
    objects_.push_back({.hub = hub, .ring = nullptr, .n_ring = n});
  }
  some_follow_ = false;
  for (std::size_t k = 0; k < objects_.size(); k++) {
    objects_[k].ring = &ring_indices_[first_ring_point[k]];
    some_follow_ = some_follow_ || (objects_[k].hub >= 0 && follows_its_ring(objects_[k].hub));
  }

  Counts now = own_counts();
  now[TORN] = lost > 0;
  now[FOLLOW] = some_follow_;
  MPI_Allreduce(MPI_IN_PLACE, now.data(), N_COUNTS, MPI_LMP_BIGINT, MPI_SUM, world);
  some_follow_ = now[FOLLOW] > 0;
  if (now[TORN]) {
    MPI_Allreduce(MPI_IN_PLACE, &lost, 1, MPI_INT, MPI_MAX, world);
    const std::string message = "an object must keep all its points, but object (molecule) " + std::to_string(lost) + " has lost one at step " +
                                std::to_string(update->ntimestep) +
                                ": a point left the box or was deleted; use walls, a shorter time step, or delete whole molecules between runs";
    end_run(lmp, *this, message);
  }
  require_all_points(now);
}

/* ----------------------------------------------------------------------
   an object that is gone as a whole leaves no point that misses its
   partners. LIGGGHTS' own thermo_modify lost ignores it by default.
------------------------------------------------------------------------- */

FixObjects::Counts FixObjects::own_counts() const
{
  Counts counts{};
  for (int i = 0; i < atom->nlocal; i++) {
    if (!is_point(i)) continue;
    counts[POINTS]++;
    if (points()[i][INDEX] >= 0.0) continue;
    counts[OBJECTS]++;
    counts[SUM_OF_IDS] += atom->molecule[i];
  }
  return counts;
}

void FixObjects::require_all_points(const Counts &now)
{
  if (now[POINTS] < counts_[POINTS]) {
    const bigint gone = counts_[OBJECTS] - now[OBJECTS];
    const std::string who = gone == 1 ? "object (molecule) " + std::to_string(counts_[SUM_OF_IDS] - now[SUM_OF_IDS]) + " has"
                                      : std::to_string(gone) + " objects have";
    const std::string message = "an object must keep all its points, but " + who + " lost all of them at step " + std::to_string(update->ntimestep) +
                                ": left the box or deleted; use walls, a shorter time step, or delete whole molecules between runs";
    end_run(lmp, *this, message);
  }
  counts_ = now;
}

void FixObjects::setup_pre_neighbor() { pre_neighbor(); }

void FixObjects::pre_neighbor()
{
  // Ghosts are new: LIGGGHTS has not yet told them what they are.
  property_->do_forward_comm();
  sizes_->do_forward_comm();
  list_objects();
  update_rotations();
}

/* ---------------------------------------------------------------------- */

void FixObjects::setup(int)
{
  require_exclusions();
  fixes_.assign(modify->fix, modify->fix + modify->nfix);
  progress_->start(clock_);
}

/* ----------------------------------------------------------------------
   LIGGGHTS calls fixes by their numbers, which it looks up at the start of
   a run, but not with 'pre no': after an unfix it would call others
------------------------------------------------------------------------- */

void FixObjects::require_same_fixes()
{
  const auto known = static_cast<int>(fixes_.size());
  // A fix that is issued again under its id may get the place in memory of the one before; only a set-up takes its mark of being new away.
  const auto is_new = [](const Fix *fix) { return fix->just_created != 0; };
  if (known <= modify->nfix && std::equal(fixes_.begin(), fixes_.end(), modify->fix) && std::none_of(fixes_.begin(), fixes_.end(), is_new)) return;
  error->fix_error(FLERR, this, ("fixes must stay during a run and those that follow it with 'pre no', but one was taken out or issued again before step " +
                                 std::to_string(update->ntimestep) + ": leave out 'pre no' in the first run after a 'fix' or 'unfix'").c_str());
}

void FixObjects::pre_initial_integrate() { require_same_fixes(); }
void FixObjects::end_of_step() { progress_->step(clock_); }

void FixObjects::post_run() { progress_->finish(clock_); }

/* ---------------------------------------------------------------------- */

void FixObjects::send_to_ghosts(double *values, int width)
{
  sent_ = values;
  sent_width_ = width;
  comm->forward_comm_fix(this);
}

int FixObjects::pack_comm(int n, int *list, double *buf, int, int *)
{
  for (int i = 0; i < n; i++) buf = std::copy_n(sent_ + sent_width_ * list[i], sent_width_, buf);
  return sent_width_;
}

void FixObjects::unpack_comm(int n, int first, double *buf)
{
  std::copy_n(buf, sent_width_ * n, sent_ + sent_width_ * first);
}

/* ---------------------------------------------------------------------- */

FixObjects *LAMMPS_NS::find_objects(LAMMPS *lmp)
{
  const int found = lmp->modify->find_fix(FixObjects::ID);
  return found < 0 ? nullptr : dynamic_cast<FixObjects *>(lmp->modify->fix[found]);
}
