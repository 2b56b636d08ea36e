#include "fix_lubrication_cds.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "fix_fluid_ib.h"
#include "fix_objects.h"
#include "fix_prescribed.h"
#include "force.h"
#include "modify.h"
#include "objects/overlap.h"
#include "options.h"
#include "update.h"

using namespace LAMMPS_NS;
using namespace FixConst;
using swellflow::ObjectPoints;
using swellflow::Range;
using swellflow::Vector2;

namespace {

constexpr double pair_part = 0.7;  // of the cutoff at a wall, measured (docs/fix_lubrication_cds.md)

}  // namespace

FixLubricationCds::FixLubricationCds(LAMMPS *lmp, int narg, char **arg) : Fix(lmp, narg, arg)
{
  swellflow::or_stop(lmp, [&] {
    swellflow::Arguments line(std::string("fix ") + id + " " + style, narg - 3, arg + 3);
    swellflow::Options options(line.place());
    options.number("viscosity", law_.viscosity, Range::positive(), "mass/(length*time)", "dynamic viscosity of the fluid").required();
    options.number("cutoff", law_.wall_cutoff, Range::positive(), "length", "gap to a wall from which on the grid resolves the force").required();
    options.number("pair_cutoff", law_.pair_cutoff, Range::positive(), "length", "the same for the gap between two discs");
    options.number("minimum", law_.minimum, Range::positive(), "length", "gap below which the force grows no more").required();
    options.parse(line);
    if (!options.given("pair_cutoff")) law_.pair_cutoff = pair_part * law_.wall_cutoff;
    const double least = std::min(law_.wall_cutoff, law_.pair_cutoff), room = std::min(domain->prd[0], domain->prd[1]);
    if (law_.wall_cutoff > room || law_.pair_cutoff > room)
      line.fail("'cutoff' and 'pair_cutoff' must be at most the shorter side of the box, " + swellflow::shown(room) + ", but are " + swellflow::shown(law_.wall_cutoff) + " and " +
                swellflow::shown(law_.pair_cutoff) + ": lower them");
    if (law_.minimum >= least)
      line.fail("'minimum' must be less than 'cutoff' and 'pair_cutoff' (" + swellflow::rounded(least) + "), but is '" + swellflow::shown(law_.minimum) + "': change it");
  });
  vector_flag = 1;
  size_vector = N_VALUES;
  global_freq = 1;
  extvector = 0;
  comm_forward = DISC_SIZE;
}

int FixLubricationCds::setmask() { return POST_FORCE; }

void FixLubricationCds::post_create() { objects_ = require_objects(lmp, *this); }

void FixLubricationCds::init()
{
  objects_ = require_objects(lmp, *this);
  groups_moved_as_told_ = 0;
  for (int k = 0; k < modify->nfix; k++)
    if (dynamic_cast<FixPrescribed *>(modify->fix[k])) groups_moved_as_told_ |= modify->fix[k]->groupbit;
  if (!comm->ghost_velocity)
    error->fix_error(FLERR, this, "the speed of an object needs the velocities of all its points, but ghosts have none: add 'communicate single vel yes'");
  require_discs();
}

void FixLubricationCds::require_discs()
{
  WorstObject other;
  for (int i = 0; i < atom->nlocal; i++) {
    if (!(atom->mask[i] & groupbit) || !objects_->is_point(i)) continue;
    const double *point = objects_->points()[i], D = point[FixObjects::DIAMETER];
    const double excess = 8.0 * point[FixObjects::MEAN_SQUARE_RADIUS] / (D * D) - 1.0;  // a disc has the least of all shapes of its area
    if (excess > 1e-6) other.meet(excess, atom->molecule[i]);
  }
  agree_on_worst(world, &other, 1);
  if (other.value > 0.0)
    error->fix_error(FLERR, this, ("the gap is that between discs, but " + name_of(other.object) +
                                   " was made with another shape: use a group of discs").c_str());
}

/// Hubs are looked for in as far as a diameter and a gap; FixObjects provides for the diameter. LIGGGHTS halves it (see there).
double FixLubricationCds::extend_cut_ghost() { return objects_->extend_cut_ghost() + 2.0 * law_.pair_cutoff; }

/* ----------------------------------------------------------------------
   velocities may have been set since ghosts were made
------------------------------------------------------------------------- */

void FixLubricationCds::setup(int)
{
  objects_->require_whole_objects(*this);
  comm->forward_comm();
  post_force(0);
}

void FixLubricationCds::post_force(int)
{
  swellflow::StepClock::Scope timing(objects_->clock(), swellflow::StepClock::springs);
  measure_discs();
  comm->forward_comm_fix(this);
  find_gaps();
  make_resistances_implicit();
  share_forces();
}

/* ---------------------------------------------------------------------- */

bool FixLubricationCds::acts_on(const ObjectPoints &object) const { return atom->mask[object.hub] & groupbit; }

bool FixLubricationCds::is_moved_as_told(int i) const { return atom->mask[i] & groups_moved_as_told_; }

/// visit(i), own or image, for the points that move the object: a hub that follows its ring does not.
template <typename Visit>
void FixLubricationCds::for_each_member(const ObjectPoints &object, const Visit &visit) const
{
  for (int k = 0; k < object.n_ring; k++) visit(object.ring[k]);
  if (!objects_->follows_its_ring(object.hub)) visit(object.hub);
}

/// The mass is the object's own. To add that of the fluid which must follow it (m + kappa dt) makes more of the film, but objects of a tenth of the density of the fluid unstable.
void FixLubricationCds::measure_discs()
{
  discs_.resize(atom->nlocal + atom->nghost);
  for (const ObjectPoints &object : objects_->objects()) {
    if (!acts_on(object) || !objects_->owns(object)) continue;
    const double *hub = atom->x[object.hub], *point = objects_->points()[object.hub];
    double mass = 0.0;
    Vector2 from_hub = Vector2::Zero(), momentum = Vector2::Zero();
    for_each_member(object, [&](int i) {
      mass += atom->rmass[i];
      from_hub += atom->rmass[i] * Vector2(atom->x[i][0] - hub[0], atom->x[i][1] - hub[1]);
      momentum += atom->rmass[i] * Vector2(atom->v[i][0], atom->v[i][1]);
    });
    discs_[objects_->own_index(object.hub)] = {{from_hub.x() / mass, from_hub.y() / mass}, {momentum.x() / mass, momentum.y() / mass},
                                               0.5 * objects_->sizes()[object.hub][FixObjects::LAMBDA] * point[FixObjects::DIAMETER],
                                               is_moved_as_told(object.hub) ? 0.0 : force->ftm2v / mass};
  }
}

int FixLubricationCds::pack_comm(int n, int *list, double *buf, int, int *)
{
  auto *out = reinterpret_cast<Disc *>(buf);
  for (int k = 0; k < n; k++) out[k] = discs_[list[k]];
  return DISC_SIZE;
}

void FixLubricationCds::unpack_comm(int n, int first, double *buf)
{
  const auto *in = reinterpret_cast<const Disc *>(buf);
  std::copy(in, in + n, discs_.begin() + first);
}

Vector2 FixLubricationCds::centre(int hub) const
{
  return {atom->x[hub][0] + discs_[hub].from_hub[0], atom->x[hub][1] + discs_[hub].from_hub[1]};
}

Vector2 FixLubricationCds::velocity(int hub) const { return {discs_[hub].velocity[0], discs_[hub].velocity[1]}; }

/* ---------------------------------------------------------------------- */

void FixLubricationCds::find_gaps()
{
  gaps_.clear();
  find_gaps_of_pairs();
  for (int i = 0; i < atom->nlocal; i++)
    if ((atom->mask[i] & groupbit) && objects_->is_point(i) && objects_->tag_of_hub(i) == atom->tag[i]) find_gaps_to_walls(i);
}

/// Images of hubs are here as ghosts, so that the box is none that is periodic.
void FixLubricationCds::find_gaps_of_pairs()
{
  std::vector<int> hubs;
  std::vector<swellflow::Circle> circles;
  const double infinity = std::numeric_limits<double>::max();
  swellflow::PlaneBox box{{infinity, infinity}, {-infinity, -infinity}};
  for (int i = 0; i < atom->nlocal + atom->nghost; i++) {
    if (!(atom->mask[i] & groupbit) || !objects_->is_point(i) || objects_->tag_of_hub(i) != atom->tag[i]) continue;
    hubs.push_back(i);
    circles.push_back({centre(i), discs_[i].radius + 0.5 * law_.pair_cutoff});
    box.low = box.low.cwiseMin(circles.back().centre);
    box.high = box.high.cwiseMax(circles.back().centre);
  }
  if (circles.empty()) return;
  const Vector2 margin = Vector2::Constant(law_.pair_cutoff);  // hubs in a row span no area
  box.low -= margin;
  box.high += margin;
  swellflow::for_each_overlapping_pair(circles, 0, box, [&](int a, int b, const Vector2 &way) {
    if (atom->tag[hubs[a]] == atom->tag[hubs[b]]) return;
    if (hubs[a] < atom->nlocal) add_gap(hubs[a], hubs[b], way);
    if (hubs[b] < atom->nlocal) add_gap(hubs[b], hubs[a], -way);
  });
}

void FixLubricationCds::add_gap(int hub, int other, const Vector2 &way)
{
  const double distance = way.norm(), R1 = discs_[hub].radius, R2 = discs_[other].radius, gap = distance - (R1 + R2);
  const double resistance = law_.missing_between(R1, R2, gap);
  if (resistance == 0.0 || distance == 0.0) return;
  const Vector2 ahead = way / distance;
  gaps_.push_back({hub, other, ahead, gap, resistance, (velocity(hub) - velocity(other)).dot(ahead)});
}

/// Walls move within their plane only.
void FixLubricationCds::find_gaps_to_walls(int hub)
{
  const Vector2 at = centre(hub);
  for (int side = 0; side < 4; side++) {
    const int d = side / 2;
    const double sign = side % 2 == 0 ? -1.0 : 1.0, place = sign < 0.0 ? domain->boxlo[d] : domain->boxhi[d];
    const double gap = sign * (place - at[d]) - discs_[hub].radius, resistance = missing_at_side(side, discs_[hub].radius, gap);
    if (resistance == 0.0) continue;
    Vector2 ahead = Vector2::Zero();
    ahead[d] = sign;
    gaps_.push_back({hub, WALL, ahead, gap, resistance, velocity(hub).dot(ahead)});
  }
}

/// Without a fluid all fixed sides are walls.
double FixLubricationCds::missing_at_side(int side, double radius, double gap) const
{
  constexpr int fixed = 1;
  if (domain->boundary[side / 2][side % 2] != fixed) return 0.0;
  const FixFluidIb *fluid = find_fluid(lmp);
  const swellflow::SideKind kind = fluid ? fluid->side(side) : swellflow::SideKind::wall;
  if (kind == swellflow::SideKind::wall) return law_.missing_at_wall(radius, gap);
  return kind == swellflow::SideKind::slip ? law_.missing_at_mirror(radius, gap) : 0.0;
}

/* ---------------------------------------------------------------------- */

void FixLubricationCds::make_resistances_implicit()
{
  std::vector<double> count(atom->nlocal + atom->nghost, 0.0);
  for (const Gap &gap : gaps_) count[gap.hub] += 1.0;
  objects_->send_to_ghosts(count.data(), 1);
  const auto share = [&](int hub) { return hub == WALL ? 0.0 : count[hub] * discs_[hub].inverse_mass; };
  for (Gap &gap : gaps_) gap.resistance = swellflow::implicit_resistance(gap.resistance, update->dt, share(gap.hub), share(gap.other));
}

/// In shares of mass: the object is accelerated as a whole, and not deformed.
void FixLubricationCds::share_forces()
{
  std::vector<double> on_hub(2 * (atom->nlocal + atom->nghost), 0.0);
  for (const Gap &gap : gaps_)
    for (int d = 0; d < 2; d++) on_hub[2 * gap.hub + d] -= gap.resistance * gap.approach * gap.ahead[d];
  objects_->send_to_ghosts(on_hub.data(), 2);

  given_.assign(2 * atom->nlocal, 0.0);
  for (const ObjectPoints &object : objects_->objects()) {
    if (!acts_on(object)) continue;
    double mass = 0.0;
    for_each_member(object, [&](int i) { mass += atom->rmass[i]; });
    for_each_member(object, [&](int i) {
      const int own = objects_->own_index(i);
      for (int d = 0; own >= 0 && d < 2; d++) {
        given_[2 * own + d] = on_hub[2 * object.hub + d] * (atom->rmass[i] / mass);
        atom->f[own][d] += given_[2 * own + d];
      }
    });
  }
}

void FixLubricationCds::add_given(double *own_xy) const
{
  for (std::size_t k = 0; k < given_.size(); k++) own_xy[k] += given_[k];
}

/// A pair is there once for each of its two hubs.
double FixLubricationCds::compute_vector(int n)
{
  double sums[2] = {0.0, 0.0}, smallest = std::max(law_.wall_cutoff, law_.pair_cutoff);
  for (const Gap &gap : gaps_) {
    const double part = gap.other == WALL ? 1.0 : 0.5;
    sums[0] += part;
    sums[1] += part * gap.resistance * gap.approach * gap.approach;
    smallest = std::min(smallest, gap.width);
  }
  MPI_Allreduce(MPI_IN_PLACE, sums, 2, MPI_DOUBLE, MPI_SUM, world);
  MPI_Allreduce(MPI_IN_PLACE, &smallest, 1, MPI_DOUBLE, MPI_MIN, world);
  return n == GAPS ? sums[0] : n == SMALLEST_GAP ? smallest : sums[1];
}
