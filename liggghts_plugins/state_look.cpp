#include "state_look.h"

#include <algorithm>
#include <cmath>

#include "atom.h"
#include "fix_objects.h"
#include "fix_swell.h"
#include "modify.h"
#include "object_geometry.h"
#include "objects/outline.h"

using namespace LAMMPS_NS;
using swellflow::ObjectPoints;

namespace {

/// Zero when all are finite, else not a number: infinity times zero is none either. Rows of LIGGGHTS' arrays follow each other in memory.
double zero_if_finite(double *const *rows, int n)
{
  constexpr int lanes = 4;
  double sums[lanes] = {};
  const double *values = n > 0 ? rows[0] : nullptr;
  const int all = 3 * n;
  int k = 0;
  for (; k + lanes <= all; k += lanes)
    for (int lane = 0; lane < lanes; lane++) sums[lane] += 0.0 * values[k + lane];
  for (; k < all; k++) sums[0] += 0.0 * values[k];
  return sums[0] + sums[1] + sums[2] + sums[3];
}

double largest_component(double *const *rows, int n)
{
  constexpr int lanes = 4;
  double largest[lanes] = {};
  const double *values = n > 0 ? rows[0] : nullptr;
  const int all = 3 * n;
  for (int k = 0; k + lanes <= all; k += lanes)
    for (int lane = 0; lane < lanes; lane++) largest[lane] = std::max(largest[lane], std::abs(values[k + lane]));
  for (int k = all - all % lanes; k < all; k++) largest[0] = std::max(largest[0], std::abs(values[k]));
  return std::max({largest[0], largest[1], largest[2], largest[3]});
}

bool is_finite(const double *row) { return std::isfinite(row[0]) && std::isfinite(row[1]) && std::isfinite(row[2]); }

/// Twice the area within the ring, signed.
double twice_area(double *const *x, const ObjectPoints &object)
{
  const double *hub = x[object.hub], *last = x[object.ring[object.n_ring - 1]];
  double before[2] = {last[0] - hub[0], last[1] - hub[1]}, sum = 0.0;
  for (int k = 0; k < object.n_ring; k++) {
    const double *point = x[object.ring[k]], now[2] = {point[0] - hub[0], point[1] - hub[1]};
    sum += before[0] * now[1] - before[1] * now[0];
    before[0] = now[0];
    before[1] = now[1];
  }
  return sum;
}

}  // namespace

/* ----------------------------------------------------------------------
   the number of an object with a bad point, 0 of an atom that is no point,
   -1: there is none
------------------------------------------------------------------------- */

int StateLook::object_not_finite() const
{
  const int n = atom->nlocal;
  if (zero_if_finite(atom->x, n) + zero_if_finite(atom->v, n) + zero_if_finite(atom->f, n) == 0.0) return -1;
  const FixObjects *objects = find_objects(lmp);
  for (int i = 0; i < n; i++)
    if (!is_finite(atom->x[i]) || !is_finite(atom->v[i]) || !is_finite(atom->f[i])) return objects && objects->is_point(i) ? atom->molecule[i] : 0;
  return -1;
}

StateLook::Findings StateLook::look(double step) const
{
  Findings worst;
  worst.fill({-HUGE_VAL, 0});
  const int bad = object_not_finite();
  worst[NOT_FINITE] = {bad >= 0 ? 1.0 : 0.0, std::max(bad, 0)};
  if (const FixObjects *objects = find_objects(lmp); objects && bad < 0) {
    look_at_objects(*objects, worst);
    look_at_speeds(*objects, step, worst);
  }
  agree_on_worst(world, worst);
  return worst;
}

void StateLook::look_at_objects(const FixObjects &objects, Findings &worst) const
{
  if (!objects.current()) return;
  double **points = objects.points();
  for (const ObjectPoints &object : objects.objects()) {
    if (!objects.owns(object)) continue;
    const double *point = points[object.hub], lambda = objects.sizes()[object.hub][FixObjects::LAMBDA];
    const double inverted = -0.5 * twice_area(atom->x, object) / (lambda * lambda * point[FixObjects::NATURAL_AREA]), crushed = inverted * std::max(lambda * lambda, 1.0);
    worst[INVERTED].meet(inverted, atom->molecule[object.hub]);
    worst[CRUSHED].meet(crushed, atom->molecule[object.hub]);
  }
}

void StateLook::begin()
{
  const FixObjects *objects = find_objects(lmp);
  smallest_radius_ = HUGE_VAL;
  for (int i = 0; objects && i < atom->nlocal; i++)
    if (objects->is_point(i)) smallest_radius_ = std::min(smallest_radius_, 0.5 * objects->points()[i][FixObjects::DIAMETER]);
  MPI_Allreduce(MPI_IN_PLACE, &smallest_radius_, 1, MPI_DOUBLE, MPI_MIN, world);
}

/// Most of the time nothing is fast for even the smallest object, which only velocities tell, that are in the cache.
void StateLook::look_at_speeds(const FixObjects &objects, double step, Findings &worst) const
{
  if (std::sqrt(2.0) * step * largest_component(atom->v, atom->nlocal) < smallest_radius_) return;
  double **points = objects.points(), largest = 0.0;
  int of = 0;
  for (int i = 0; i < atom->nlocal; i++) {
    const double *v = atom->v[i], *point = points[i], radius = 0.5 * std::max(objects.sizes()[i][FixObjects::LAMBDA], 1.0) * point[FixObjects::DIAMETER];
    const double square = v[0] * v[0] + v[1] * v[1];
    if (!(square > largest * radius * radius) || radius == 0.0) continue;
    largest = square / (radius * radius);
    of = atom->molecule[i];
  }
  worst[RUNAWAY] = {step * std::sqrt(largest), of};
}

/* ---------------------------------------------------------------------- */

void AreaBalance::begin()
{
  first_ = {};
  most_ = error_ = 0.0;
}

void AreaBalance::add(const FixObjects &objects, const ObjectPoints &object, Sum sum, Sums &sums) const
{
  const double *point = objects.points()[object.hub], lambda = objects.sizes()[object.hub][FixObjects::LAMBDA];
  sums[sum] += swellflow::polygon_area(outline_of(lmp, object)).area;
  if (sum == DRINK) sums[DRINK_NATURAL] += lambda * lambda * point[FixObjects::NATURAL_AREA];
}

void AreaBalance::look()
{
  const FixObjects *objects = find_objects(lmp);
  if (!objects || !objects->current_everywhere()) return;
  int drinking = 0, inflating = 0;  // bits of groups
  for (int k = 0; k < modify->nfix; k++)
    if (const auto *swell = dynamic_cast<const FixSwell *>(modify->fix[k])) (swell->absorbs() ? drinking : inflating) |= swell->groupbit;
  Sums sums{};
  for (const ObjectPoints &object : objects->objects()) {
    const int mask = atom->mask[object.hub];
    if (objects->owns(object) && !(mask & inflating)) add(*objects, object, mask & drinking ? DRINK : KEEP, sums);
  }
  MPI_Allreduce(MPI_IN_PLACE, sums.data(), N_SUMS, MPI_DOUBLE, MPI_SUM, world);
  if (!knows()) first_ = sums;
  most_ = std::max(most_, sums[DRINK]);
  if (first_[KEEP] > 0.0) error_ = std::max(error_, std::abs(sums[KEEP] / first_[KEEP] - 1.0));
  const double held = std::min(most_, sums[DRINK_NATURAL]);
  if (held > 0.0) error_ = std::max(error_, 1.0 - sums[DRINK] / held);
}
