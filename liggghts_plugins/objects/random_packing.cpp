#include "random_packing.h"

#include <cmath>
#include <numbers>

#include "packing_relaxation.h"
#include "packing_shake.h"
#include "random_places.h"

namespace swellflow {

namespace {

constexpr int last_sweeps = 100, sweeps_between_growths = 20;
constexpr double finest_growth = 0.005;  ///< of the solid fraction

std::vector<Placement> started(const PackingTask &task, RandomNumbers &random)
{
  const std::vector<Vector2> centres = random_places(task, random);
  std::vector<Placement> placements;
  for (const Vector2 &centre : centres) placements.push_back({centre, task.turning ? 2.0 * std::numbers::pi * random.next() : 0.0});
  return placements;
}

/// By bisection of the share of the solid fraction that fits, each time from the last state that did.
Packing grown(const PackingTask &task, std::vector<Placement> start, RandomNumbers &random)
{
  Packing packing{std::move(start), 0.0};
  double fits = 0.0, jams = 1.0;
  while (jams - fits > finest_growth) {
    // Nearly all is likely to fit in the end, so the first step goes a long way.
    const double share = fits == 0.0 && jams == 1.0 ? 0.9 : 0.5 * (fits + jams);
    PackedBodies bodies(task, std::sqrt(share), packing.placements);
    if (!relax_overlaps(bodies)) {
      jams = share;
      continue;
    }
    shake(bodies, sweeps_between_growths, random);
    packing = {bodies.placements(), std::sqrt(share)};
    fits = share;
    if (jams == 1.0) {
      PackedBodies whole(task, 1.0, packing.placements);
      if (relax_overlaps(whole)) return {whole.placements(), 1.0};
    }
  }
  return packing;
}

}  // namespace

Packing pack_at_random(const PackingTask &task)
{
  RandomNumbers random(Purpose::object_place, task.seed);
  Packing packing{started(task, random), 1.0};
  PackedBodies at_once(task, 1.0, packing.placements);
  if (relax_overlaps(at_once))
    packing.placements = at_once.placements();
  else
    packing = grown(task, at_once.placements(), random);
  PackedBodies bodies(task, packing.scale, packing.placements);
  shake(bodies, last_sweeps, random);
  packing.placements = bodies.placements();
  for (Placement &placement : packing.placements) placement.centre = task.room->box().wrapped(placement.centre);
  return packing;
}

}  // namespace swellflow
