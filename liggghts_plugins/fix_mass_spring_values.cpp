// Values of fix mass_spring for thermo, and the guard on explicit time steps.
#include <algorithm>
#include <cmath>

#include "atom.h"
#include "error.h"
#include "fix_mass_spring.h"
#include "fix_objects.h"
#include "guard.h"
#include "modify.h"
#include "object_geometry.h"
#include "objects/vibrations.h"
#include "options.h"
#include "update.h"

using namespace LAMMPS_NS;
using swellflow::ObjectPoints;
using swellflow::Vector2;

namespace {

Vector2 plane(const double *x) { return {x[0], x[1]}; }

}  // namespace

double FixMassSpring::energy_of(const ObjectPoints &object) const
{
  double energy = 0.0;
  const double *const *x = atom->x;
  swellflow::for_each_spring(springs_of(object), [&](int k, int other, const swellflow::Spring &spring) {
    const int a = object.ring[k], b = other == object.n_ring ? object.hub : object.ring[other];
    const double stretch = (plane(x[a]) - plane(x[b])).norm() - spring.length;
    energy += 0.5 * spring.stiffness * stretch * stretch;
  });
  return energy;
}

/* ----------------------------------------------------------------------
   Each spring is counted by the rank of its ring point.
------------------------------------------------------------------------- */

/// Of own points and images, all of the end of the step, where images still have those of its middle.
std::vector<double> FixMassSpring::velocities() const
{
  std::vector<double> v(2 * (atom->nlocal + atom->nghost));
  for (int i = 0; i < atom->nlocal; i++)
    for (int d = 0; d < 2; d++) v[2 * i + d] = atom->v[i][d];
  objects_->send_to_ghosts(v.data(), 2);
  return v;
}

const FixMassSpring::Totals &FixMassSpring::totals()
{
  if (totals_step_ == update->ntimestep) return totals_;
  double **x = atom->x;
  double sums[2] = {0.0, 0.0}, largest_strain = 0.0;
  const bool current = objects_->current_everywhere();
  const std::vector<double> v = current && damped() ? velocities() : std::vector<double>(2 * (atom->nlocal + atom->nghost), 0.0);
  for (std::size_t k = 0; current && k < objects_->objects().size(); k++) {
    const ObjectPoints &object = objects_->objects()[k];
    if (!acts_on(object)) continue;
    swellflow::for_each_spring(springs_of(object), [&](int i, int other, const swellflow::Spring &spring) {
      const int a = object.ring[i], b = other == object.n_ring ? object.hub : object.ring[other];
      if (objects_->own_index(a) < 0) return;
      const double stretch = (plane(x[a]) - plane(x[b])).norm() - spring.length;
      sums[0] += 0.5 * spring.stiffness * stretch * stretch;
      if (spring.length > 0.0) largest_strain = std::max(largest_strain, std::abs(stretch) / spring.length);
      const double closing = (plane(&v[2 * a]) - plane(&v[2 * b])).dot(swellflow::Direction(plane(x[a]), plane(x[b])).n);
      sums[1] += spring.dashpot * closing * closing;
    });
  }
  MPI_Allreduce(MPI_IN_PLACE, sums, 2, MPI_DOUBLE, MPI_SUM, world);
  MPI_Allreduce(MPI_IN_PLACE, &largest_strain, 1, MPI_DOUBLE, MPI_MAX, world);
  totals_ = {.energy = sums[0], .largest_strain = largest_strain, .dissipated_power = sums[1]};
  totals_step_ = update->ntimestep;
  return totals_;
}

double FixMassSpring::compute_scalar() { return totals().energy; }

double FixMassSpring::compute_vector(int n)
{
  if (n == 3) return objects_->current_everywhere() ? step_over_limit(0.0).value : 0.0;
  const Totals &now = totals();
  const double values[] = {now.energy, now.largest_strain, now.dissipated_power};
  return values[n];
}

bool FixMassSpring::moves_explicitly(const ObjectPoints &object) const
{
  return gives_forces_to(object) && (atom->mask[object.hub] & explicit_groups_);
}

/* ----------------------------------------------------------------------
   all springs longer, and all points farther from the hub, by the same
   factor: omega^2 = sum of k L^2 over sum of m r^2
------------------------------------------------------------------------- */

double FixMassSpring::breathing_frequency(const ObjectPoints &object) const
{
  if (!acts_on(object) || !(atom->mask[object.hub] & (solved_groups_ | explicit_groups_))) return 0.0;
  double stiffness = 0.0, inertia = 0.0;
  swellflow::for_each_spring(springs_of(object), [&](int, int, const swellflow::Spring &spring) { stiffness += spring.stiffness * spring.length * spring.length; });
  const Vector2 hub = plane(atom->x[object.hub]);
  for_each_point(object, [&](int i) { inertia += atom->rmass[i] * (plane(atom->x[i]) - hub).squaredNorm(); });
  return std::sqrt(stiffness / inertia);
}

/* ----------------------------------------------------------------------
   The largest step over the limit of an object as it is, if above `floor`.
   Only objects that are above all before are looked at closely. Collective.
------------------------------------------------------------------------- */

WorstObject FixMassSpring::step_over_limit(double floor) const
{
  WorstObject largest{floor, 0};
  std::vector<Vector2> x;
  std::vector<double> mass;
  for (const ObjectPoints &object : objects_->objects()) {
    if (!objects_->owns(object) || !moves_explicitly(object)) continue;
    x.clear();
    mass.clear();
    for_each_point(object, [&](int i) {
      x.push_back(plane(atom->x[i]));
      mass.push_back(atom->rmass[i]);
    });
    const swellflow::SpringSet &springs = springs_of(object);
    if (bound_of_step_over_limit(x, mass, springs, update->dt) <= largest.value) continue;
    if (largest.value > 0.0 && step_is_below(x, mass, springs, update->dt, largest.value)) continue;
    largest = {swellflow::step_over_limit(x, mass, springs, update->dt), atom->molecule[object.hub]};
  }
  agree_on_worst(world, &largest, 1);
  return largest;
}

void FixMassSpring::add_limits(std::vector<swellflow::Figure> &figures)
{
  if (!objects_ || !objects_->current_everywhere()) return;
  const WorstObject largest = step_over_limit(0.0);
  if (largest.object > 0) figures.push_back(figure_of(largest));
}

swellflow::Figure FixMassSpring::figure_of(const WorstObject &limit) const
{
  return {.name = "time step over the longest with which springs are stable", .value = limit.value, .watch = 0.95, .poor = 1.0,
          .place = name_of(limit.object) + " and fix " + id,
          .remedy = "shorten 'timestep' to " + swellflow::rounded(update->dt / limit.value) + ", or move the objects with 'nve/cds implicit' or 'rigid/cds'"};
}

/// In the run: only what is beyond the limit is looked at closely.
void FixMassSpring::judge_step() const
{
  const WorstObject largest = step_over_limit(1.0);
  if (largest.object > 0) judge(lmp, figure_of(largest));
}
