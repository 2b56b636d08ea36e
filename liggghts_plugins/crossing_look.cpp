#include "crossing_look.h"

#include <array>

#include "atom.h"
#include "domain.h"
#include "fix_objects.h"
#include "force.h"
#include "neigh_list.h"
#include "pair.h"

using namespace LAMMPS_NS;

CrossingLook::Touches CrossingLook::touches(const FixObjects &objects) const
{
  Touches found;
  const NeighList *list = force->pair_match("gran", 0) ? force->pair->list : nullptr;
  for (int n = 0; list && n < list->inum; n++) {
    const int i = list->ilist[n];
    for (int k = 0; k < list->numneigh[i] && objects.is_point(i); k++) {
      const int j = list->firstneigh[i][k] & NEIGHMASK;
      double square = 0.0;
      for (int d = 0; d < 3; d++) square += (atom->x[i][d] - atom->x[j][d]) * (atom->x[i][d] - atom->x[j][d]);
      const double reach = atom->radius[i] + atom->radius[j];
      if (square >= reach * reach || !objects.is_point(j) || objects.tag_of_hub(i) == objects.tag_of_hub(j)) continue;
      found[objects.tag_of_hub(i)].insert(objects.tag_of_hub(j));
      found[objects.tag_of_hub(j)].insert(objects.tag_of_hub(i));
    }
  }
  return found;
}

/// By how often a line from the hub outwards meets the ring, whose points are all near that of its own hub: in a periodic box the two objects are taken as near as they come.
bool CrossingLook::holds(const swellflow::ObjectPoints &object, int hub) const
{
  std::array<double, 3> between;
  for (int d = 0; d < 3; d++) between[d] = atom->x[object.hub][d] - atom->x[hub][d];
  domain->minimum_image(between.data());
  const auto from_hub = [&](int k) {
    std::array<double, 3> r;
    for (int d = 0; d < 3; d++) r[d] = between[d] + atom->x[object.ring[k]][d] - atom->x[object.hub][d];
    return r;
  };
  bool inside = false;
  auto a = from_hub(object.n_ring - 1);
  for (int k = 0; k < object.n_ring; k++) {
    const auto b = from_hub(k);
    if ((a[1] > 0.0) != (b[1] > 0.0) && a[0] - a[1] * (b[0] - a[0]) / (b[1] - a[1]) > 0.0) inside = !inside;
    a = b;
  }
  return inside;
}

WorstObject CrossingLook::look() const
{
  std::array<WorstObject, 1> worst;
  const FixObjects *objects = find_objects(lmp);
  if (!objects || !objects->current_everywhere()) return worst[0];
  const Touches found = touches(*objects);
  for (const swellflow::ObjectPoints &object : objects->objects()) {
    const auto others = found.find(atom->tag[object.hub]);
    if (others == found.end()) continue;
    for (const int tag : others->second)
      if (const int hub = atom->map(tag); hub >= 0 && holds(object, hub)) worst[0].meet(1.0, atom->molecule[object.hub]);
  }
  agree_on_worst(world, worst);
  return worst[0];
}
