#include "random_objects.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "objects/circle_cover.h"
#include "objects/random_packing.h"
#include "shape_options.h"

namespace swellflow {

namespace {

constexpr double cover_tolerance = 0.01;  ///< of the diameter, by which the circles that stand for an outline reach beyond it

/// How many objects: a number, or a share of the place that they cover.
struct Amount {
  int number = 0;
  double solid_fraction = 0.0;
};

Amount read_amount(Arguments &line)
{
  Amount amount;
  if (line.choice("how many", {"number", "solid_fraction"}) == 0)
    amount.number = line.integer("number", {.low = 1.0, .high = most_objects});
  else
    amount.solid_fraction = line.number("solid_fraction", {.low = 0.0, .high = 1.0, .low_open = true, .high_open = true});
  return amount;
}

std::shared_ptr<const PackingRoom> read_rectangle(Arguments &line, const PlaneBox &box)
{
  Vector2 low, high;
  for (int d = 0; d < 2; ++d) {
    low[d] = line.number("rectangle", Range::any(), "length");
    high[d] = line.number("rectangle", Range::any(), "length");
    if (low[d] < box.low[d] || high[d] > box.high[d] || low[d] >= high[d])
      line.fail(std::string("a rectangle must lie in the box, which reaches in ") + "xy"[d] + " from " + shown(box.low[d]) + " to " + shown(box.high[d]) +
                ", but is from " + shown(low[d]) + " to " + shown(high[d]) + ": change it");
  }
  return std::make_shared<RectangularRoom>(box, low, high);
}

std::shared_ptr<const PackingRoom> read_room(Arguments &line, const ObjectScene &scene)
{
  line.expect("within");
  const int kind = line.choice("within", {"box", "rectangle", "region"});
  if (kind == 0) return std::make_shared<RectangularRoom>(scene.box());
  if (kind == 1) return read_rectangle(line, scene.box());
  const std::string id = line.word("region");
  const auto room = scene.region(id);
  if (!room) line.fail("'region' must name a region, but there is no '" + id + "': add it above, or correct the name");
  return room;
}

double area_of(const NewObject &object) { return 0.25 * std::numbers::pi * object.diameter * object.diameter; }

double area_of(const std::vector<NewObject> &objects)
{
  double sum = 0.0;
  for (const NewObject &object : objects) sum += area_of(object);
  return sum;
}

/// Objects of the sizes that the keywords ask for, as many as bring their area nearest to the one wanted; the small rest is made up for by all sizes together.
std::vector<NewObject> filling(const NewObject &pattern, const ShapeOptions &shape, double area, const Arguments &line)
{
  if (area > most_objects * area_of(pattern)) line.fail("there must be at most 1e7 objects, but more are needed: make them larger");
  std::vector<NewObject> objects;
  for (double covered = 0.0;;) {
    NewObject next = pattern;
    next.diameter *= shape.size_factor(objects.size());
    if (covered + 0.5 * area_of(next) > area) break;
    covered += area_of(next);
    objects.push_back(next);
  }
  if (objects.empty())
    line.fail("there must be at least one object, but the area to be covered, " + rounded(area) + ", is less than half of one: raise 'solid_fraction'");
  const double factor = std::sqrt(area / area_of(objects));
  for (NewObject &object : objects) object.diameter *= factor;
  return objects;
}

std::vector<NewObject> numbered(const NewObject &pattern, const ShapeOptions &shape, int number)
{
  std::vector<NewObject> objects(number, pattern);
  for (int k = 0; k < number; ++k) objects[k].diameter *= shape.size_factor(k);
  return objects;
}

std::string rounded_factor(double factor)
{
  char text[32];
  std::snprintf(text, sizeof text, "%.5f", factor);
  return text;
}

std::shared_ptr<const std::vector<Circle>> cover_of(const NewObject &pattern)
{
  if (pattern.shape->is_round) return std::make_shared<std::vector<Circle>>(1, Circle{Vector2::Zero(), 0.5});
  Polygon outline = pattern.footprint().outline;
  for (Vector2 &x : outline) x /= pattern.diameter;
  return std::make_shared<std::vector<Circle>>(covering_circles(outline, cover_tolerance));
}

/// Circles that cover the objects which are there, with the distance that they are to be kept from others.
std::vector<Circle> obstacles(const std::vector<ExistingObject> &existing, const PackingRoom &room, double gap)
{
  const Vector2 middle = 0.5 * (room.low() + room.high()), half = 0.5 * (room.high() - room.low());
  std::vector<Circle> all;
  for (const auto &[footprint, reach] : existing) {
    const auto &[centre, radius] = footprint.circle;
    const double margin = std::max(0.5 * gap, reach);
    const Vector2 off = room.box().difference(centre, middle).cwiseAbs() - half;
    if (off.maxCoeff() > radius + 2.0 * margin) continue;
    for (const Circle &circle : covering_circles(footprint.outline, 2.0 * cover_tolerance * radius)) all.push_back({centre + circle.centre, circle.radius + margin});
  }
  return all;
}

PackingTask packing_of(const std::vector<NewObject> &objects, std::shared_ptr<const PackingRoom> room, double gap, const ObjectScene &scene)
{
  PackingTask task;
  task.room = room;
  task.obstacles = obstacles(scene.existing(), *room, gap);
  const auto cover = cover_of(objects.front());
  for (const NewObject &object : objects) {
    const double reach = object.shape->reach * object.diameter;
    task.items.push_back({cover, object.diameter, std::max(0.5 * gap, reach), std::max(gap, reach)});
  }
  return task;
}

/// What the place has no room for, and the rule that it breaks.
std::string too_much(const Amount &amount, double wanted)
{
  return "the objects must fit into their place, but " + (amount.number ? std::to_string(amount.number) + " objects, " : std::string()) + "a solid fraction of " + rounded(wanted);
}

[[noreturn]] void refuse(const Arguments &line, const Amount &amount, double wanted, double reached, double reach)
{
  line.fail(too_much(amount, wanted) + ", does not: about " + rounded(reached) + " can be reached there, with the same 'gap'" +
            (reach > 0.0 ? " and with spheres that reach " + rounded(reach) + " diameters beyond the outlines" : "") +
            (reach > 0.0 ? ": ask for less, or lower 'gap' or 'reach'" : ": ask for less, or lower 'gap'"));
}

}  // namespace

ObjectList read_random_objects(Arguments &line, const ObjectScene &scene)
{
  const Amount amount = read_amount(line);
  const auto room = read_room(line, scene);
  const auto kind = static_cast<ShapeOptions::Kind>(line.choice("shape", ShapeOptions::names));
  ShapeOptions shape(kind, line, scene);
  int seed = 0, orientation = 0;
  double gap = 0.0;
  shape.read(line, nullptr, [&](Options &options) {
    options.integer("seed", seed, Range::at_least(0), "of the places").required();
    options.number("gap", gap, Range::not_negative(), "length", "least distance of outlines from each other and from the sides of the place");
    options.choice("orientation", orientation, {"random", "aligned"}, "whether each object is turned by chance");
  });
  const NewObject pattern = shape.object(line.place(), {});
  const double expected = amount.number ? amount.number : amount.solid_fraction * room->area() / area_of(pattern);
  scene.require_room(line.place(), expected * (pattern.shape->ring.size() + 1.0));
  std::vector<NewObject> objects =
      amount.number ? numbered(pattern, shape, amount.number) : filling(pattern, shape, amount.solid_fraction * room->area(), line);

  const double fraction = area_of(objects) / room->area();
  if (fraction >= 1.0) line.fail(too_much(amount, fraction) + ", is more than the place: ask for less");

  PackingTask task = packing_of(objects, room, gap, scene);
  task.turning = orientation == 0;
  task.seed = seed;
  const Packing packing = pack_at_random(task);
  if (packing.scale < 1.0) refuse(line, amount, fraction, fraction * packing.scale * packing.scale, pattern.shape->reach);
  for (std::size_t k = 0; k < objects.size(); ++k) {
    objects[k].centre = packing.placements[k].centre;
    objects[k].angle += packing.placements[k].angle * 180.0 / std::numbers::pi;
  }
  std::string remark = ", solid fraction " + rounded(fraction);
  if (!amount.number) remark += ", diameters times " + rounded_factor(objects.front().diameter / (pattern.diameter * shape.size_factor(0)));
  return {.objects = std::move(objects), .remark = remark};
}

}  // namespace swellflow
