// Which places new objects may have, and which they may not.
#include <algorithm>
#include <cmath>
#include <map>

#include "all_ranks.h"
#include "atom.h"
#include "comm.h"
#include "create_objects.h"
#include "domain.h"
#include "error.h"
#include "fix_objects.h"
#include "memory_room.h"
#include "modify.h"
#include "objects/outline.h"
#include "options.h"

using namespace LAMMPS_NS;
using swellflow::ExistingObject;
using swellflow::Footprint;
using swellflow::NewObject;
using swellflow::shown;
using swellflow::Vector2;

namespace {

std::string position(const Vector2 &x) { return "(" + shown(x.x()) + ", " + shown(x.y()) + ")"; }

/// Centres of the contact detection spheres on the ring, about the object's centre.
std::vector<Vector2> spheres_of(const NewObject &object)
{
  std::vector<Vector2> spheres;
  for (const auto &point : object.shape->ring)
    if (point.has_cds) spheres.push_back(object.placed(point.x));
  return spheres;
}

}  // namespace

void CreateObjects::require_settings() const
{
  const std::string problem = why_no_objects(lmp);
  if (!problem.empty()) throw swellflow::OptionError("create_objects: " + problem);
  if (modify->nfix_restart_peratom)
    throw swellflow::OptionError("create_objects: objects can be added to those of a restart file only after a run: add 'run 0' above");
}

void CreateObjects::require_room(const std::string &place, double points) const
{
  constexpr double bytes_a_point = 1000.0;  // of LIGGGHTS' arrays and lists
  const double all = static_cast<double>(atom->natoms) + points;
  if (all >= MAXSMALLINT)
    throw swellflow::OptionError(place + ": LIGGGHTS numbers points up to " + std::to_string(MAXSMALLINT) + ", but there would be " + swellflow::rounded(all) +
                                 ": make fewer objects, or with fewer 'points'");
  swellflow::require_memory(world, place, swellflow::rounded(points) + " points", bytes_a_point * points);
}

swellflow::PlaneBox CreateObjects::box() const
{
  return {.low = {domain->boxlo[0], domain->boxlo[1]},
          .high = {domain->boxhi[0], domain->boxhi[1]},
          .periodic = {domain->xperiodic != 0, domain->yperiodic != 0}};
}

void CreateObjects::check_place(const NewObject &object) const
{
  const auto fail = [&](const std::string &message) { throw swellflow::OptionError(object.place + ": " + message); };
  if (object.type > atom->ntypes)
    fail("'type' must be one of the box's " + std::to_string(atom->ntypes) + " atom types, but is " + std::to_string(object.type) +
         ": change it, or the number in create_box");
  const swellflow::PlaneBox whole = box();
  const Footprint footprint = object.footprint();
  for (int d = 0; d < 2; d++) {
    const double low = whole.low[d], high = whole.high[d], at = object.centre[d];
    double below = -footprint.circle.radius, above = footprint.circle.radius;
    if (!footprint.outline.empty()) {
      below = above = 0.0;
      for (const Vector2 &vertex : footprint.outline) below = std::min(below, vertex[d]), above = std::max(above, vertex[d]);
    }
    const std::string who = "the one at " + position(object.centre) + ", which is " + swellflow::rounded(above - below) + " wide in " + "xy"[d],
                      ends = "box from " + shown(low) + " to " + shown(high) + ": move it, or make the box larger";
    if (whole.periodic[d] && (above - below >= 0.5 * (high - low) || at < low || at >= high))
      fail("an object must have its centre in a periodic box at least twice its size, but " + who + ", has not, in the " + ends);
    if (!whole.periodic[d] && (at + below <= low - overlap_ || at + above >= high + overlap_))
      fail("an object must lie inside the box and not touch its sides, but " + who + ", touches or leaves the " + ends);
  }
}

void CreateObjects::check_overlap() const
{
  std::vector<Footprint> footprints;
  for (ExistingObject &object : existing_objects()) footprints.push_back(std::move(object.footprint));
  const int first_new = footprints.size();
  for (const NewObject &object : objects_) footprints.push_back(object.footprint());
  const auto overlap = swellflow::deepest_overlap(footprints, first_new, box());
  if (overlap && overlap->depth > overlap_) {
    const auto place = [&](int k) { return position(footprints[k].circle.centre); };
    const bool with_earlier = overlap->first < first_new;
    throw swellflow::OptionError(objects_[overlap->second - first_new].place + ": objects must not overlap, but the one at " +
                                 place(overlap->second) + " overlaps " + (with_earlier ? "an earlier one at " : "the one at ") +
                                 place(overlap->first) + " by " + swellflow::rounded(overlap->depth) + ": move one, or make it smaller");
  }
  footprints.erase(footprints.begin(), footprints.begin() + first_new);
  warn_of_contacts(footprints);
}

void CreateObjects::warn_of_contacts(const std::vector<Footprint> &footprints) const
{
  std::vector<swellflow::Circle> circles;
  for (std::size_t k = 0; k < objects_.size(); k++)
    circles.push_back({objects_[k].centre, footprints[k].circle.radius + objects_[k].shape->reach * objects_[k].diameter});
  swellflow::Overlap deepest{0, 0, 0.0};
  swellflow::for_each_overlapping_pair(circles, 0, box(), [&](int i, int j, const Vector2 &way) {
    const std::vector<Vector2> spheres_i = spheres_of(objects_[i]), spheres_j = spheres_of(objects_[j]);
    const double touch = objects_[i].cds_radius() + objects_[j].cds_radius();
    double nearest_squared = touch * touch;
    for (const Vector2 &b : spheres_j)
      for (const Vector2 &a : spheres_i) nearest_squared = std::min(nearest_squared, (way + b - a).squaredNorm());
    const double depth = touch - std::sqrt(nearest_squared);
    if (depth > deepest.depth) deepest = {i, j, depth};
  });
  if (deepest.depth > 0.0 && comm->me == 0)
    error->warning(FLERR, ("create_objects: contact detection spheres of the objects at " + position(objects_[deepest.first].centre) + " and " +
                           position(objects_[deepest.second].centre) + " touch from the start, by " + swellflow::rounded(deepest.depth)).c_str());
}

/* ----------------------------------------------------------------------
   outlines of objects made earlier where they are now, at no less than
   their natural size. Their points may lie on several ranks.
------------------------------------------------------------------------- */

std::vector<ExistingObject> CreateObjects::existing_objects() const
{
  struct Point {
    int hub_tag, index, ring_points;
    double x, y, outline_offset, natural_area, reach;
  };
  std::vector<Point> own;
  if (const FixObjects *objects = find_objects(lmp))
    for (int i = 0; i < atom->nlocal; i++) {
      if (!objects->is_point(i)) continue;
      double x[3];
      domain->unmap(atom->x[i], atom->image[i], x);
      const double *point = objects->points()[i], lambda = objects->sizes()[i][FixObjects::LAMBDA];
      own.push_back({objects->tag_of_hub(i), static_cast<int>(point[FixObjects::INDEX]), static_cast<int>(point[FixObjects::RING_POINTS]), x[0], x[1],
                     lambda * point[FixObjects::OUTLINE_OFFSET], lambda * lambda * point[FixObjects::NATURAL_AREA],
                     point[FixObjects::HAS_CDS] ? atom->radius[i] - lambda * point[FixObjects::OUTLINE_OFFSET] : 0.0});
    }
  std::map<int, std::vector<Point>> objects;  // by tag: in the same order on any number of ranks
  for (const Point &point : from_all_ranks(own, world)) {
    auto &points = objects[point.hub_tag];
    points.resize(point.ring_points + 1);
    points[point.index + 1] = point;
  }
  std::vector<ExistingObject> existing;
  for (const auto &[tag, points] : objects) {
    const Vector2 hub(points[0].x, points[0].y);
    existing.push_back({{{hub, 0.0}, {}}, 0.0});
    Footprint &footprint = existing.back().footprint;
    for (std::size_t k = 1; k < points.size(); k++) {
      footprint.outline.push_back(swellflow::outline_point(Vector2(points[k].x, points[k].y) - hub, points[k].outline_offset));
      existing.back().reach = std::max(existing.back().reach, points[k].reach);
    }
    const double area = swellflow::outline_shape(footprint.outline).area;
    const double growth = area > 0.0 ? std::max(1.0, std::sqrt(points[0].natural_area / area)) : 1.0;
    for (Vector2 &vertex : footprint.outline) {
      vertex *= growth;
      footprint.circle.radius = std::max(footprint.circle.radius, vertex.norm());
    }
  }
  return existing;
}
