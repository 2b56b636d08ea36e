#include "shape.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

#include "contact_offset.h"
#include "mass_sharing.h"
#include "outline.h"

namespace swellflow {

using std::numbers::pi;

namespace {

/// Of the whole mass; enough for LIGGGHTS, which divides by it, and too little to be felt.
constexpr double mass_of_free_hub = 1e-9;

std::string point_name(std::size_t k) { return "point " + std::to_string(k + 1); }

void check_outline(const Shape &shape)
{
  const Polygon &outline = shape.outline;
  if (outline.size() < 3) throw std::invalid_argument("'points' must be 0 (the file's own) or at least 3, but is " + std::to_string(outline.size()) + ": change it");
  if (const auto edges = self_intersection(outline))
    throw std::invalid_argument("the outline through the ring points must not cross itself, but behind " + point_name(edges->first) + " and " +
                                point_name(edges->second) + " it does: use more 'points'");
  if (!shape.spokes) return;
  for (std::size_t k = 0; k < outline.size(); ++k)
    if (cross(outline[k], outline[after(outline, k)]) <= 1e-9)
      throw std::invalid_argument("spokes must stay inside the outline, but the hub, at the centroid, does not see the side behind " + point_name(k) +
                                  " from inside: use 'spokes no', or an outline without such bays");
}

void place_points(const ShapeRequest &request, Shape &shape)
{
  const double inset = shape.cds - shape.reach;
  for (std::size_t k = 0; k < shape.outline.size(); ++k) {
    const Vector2 &vertex = shape.outline[k];
    const double offset = inset == 0.0 ? 0.0 : contact_offset(*request.contour, vertex, inset);
    shape.ring.push_back({.x = inset == 0.0 ? vertex : outline_point(vertex, -offset), .outline_offset = offset, .weight = 1.0, .ring_length = 0.0,
                          .spoke_length = 0.0, .has_cds = true});
  }
}

/// A disc's in closed form, so that they do not depend on the direction of a spring by round-off.
void measure_springs(Shape &shape)
{
  const std::size_t n = shape.ring.size();
  for (std::size_t k = 0; k < n; ++k) {
    Shape::RingPoint &point = shape.ring[k];
    const double round_radius = 0.5 - point.outline_offset;
    point.ring_length = shape.is_round ? 2.0 * round_radius * std::sin(pi / n) : (shape.ring[k + 1 < n ? k + 1 : 0].x - point.x).norm();
    point.spoke_length = shape.is_round ? round_radius : (point.x - shape.hub).norm();
  }
}

void choose_spheres(const ShapeRequest &request, Shape &shape)
{
  const int n = static_cast<int>(shape.ring.size()), spheres = request.cds_points == 0 ? n : request.cds_points;
  if (n % spheres != 0)
    throw std::invalid_argument("'cds_points' must divide the number of ring points, " + std::to_string(n) + ", but is " + std::to_string(spheres) + ": change it");
  for (int k = 0; k < n; ++k) shape.ring[k].has_cds = k % (n / spheres) == 0;
  shape.hub_has_cds = request.hub_cds && request.spokes;
}

void share_mass(const ShapeRequest &request, Shape &shape)
{
  const int n = static_cast<int>(shape.ring.size());
  shape.share = request.share;
  if (request.share == MassShare::hub_half && !shape.is_round) {
    const std::vector<double> weights = centred_weights(shape.ring, shape.outline);
    for (int k = 0; k < n; ++k) shape.ring[k].weight = weights[k];
  }
  if (!request.spokes) {
    shape.hub_share = mass_of_free_hub;
  } else if (request.share == MassShare::equal) {
    shape.hub_share = 1.0 / (n + 1);
  } else {
    shape.hub_share = hub_share_for_inertia(shape);
  }
  if (shape.is_round) return;
  for (const Shape::RingPoint &point : shape.ring) shape.centre_of_mass += (1.0 - shape.hub_share) / n * point.weight * point.x;
  shape.centre_of_mass += shape.hub_share * shape.hub;
}

}  // namespace

double Shape::natural_area(double diameter) const
{
  if (is_round) return regular_polygon_area(static_cast<int>(ring.size()), diameter);
  return outline_area * diameter * diameter;
}

double Shape::longest_side() const
{
  double longest = 0.0;
  for (std::size_t k = 0; k < outline.size(); ++k) longest = std::max(longest, (outline[after(outline, k)] - outline[k]).norm());
  return longest;
}

double Shape::mass(double diameter, double density) const { return density * 0.25 * pi * diameter * diameter; }

double Shape::hub_mass(double mass) const
{
  return spokes && share == MassShare::equal ? mass / (ring.size() + 1) : hub_share * mass;
}

double Shape::ring_point_mass(int k, double mass) const { return (mass - hub_mass(mass)) / ring.size() * ring[k].weight; }

Shape make_shape(const ShapeRequest &request)
{
  Shape shape;
  shape.spokes = request.spokes;
  shape.is_round = request.contour->is_round();
  shape.cds = request.cds;
  shape.reach = request.reach.value_or(request.cds);
  if (shape.reach < shape.cds && !shape.spokes)
    throw std::invalid_argument("mass points inside the outline need spokes, which say where inside is, but 'reach' is less than 'cds' with 'spokes no': "
                                "leave 'reach' out");
  // Slenderer shapes want points, markers and circles without end.
  if (!request.contour->lies_within(15.0))
    throw std::invalid_argument("a shape must reach at most 15 diameters of the disc of its area from its centre, but this one reaches farther: make it less slender");
  shape.outline = request.contour->points(request.points, request.spacing);
  check_outline(shape);
  shape.outline_area = outline_shape(shape.outline).area;
  shape.mean_square_radius = request.contour->mean_square_radius();
  place_points(request, shape);
  if (!shape.spokes) {
    for (const Shape::RingPoint &point : shape.ring) shape.hub += point.x / static_cast<double>(shape.ring.size());
  }
  measure_springs(shape);
  choose_spheres(request, shape);
  share_mass(request, shape);
  return shape;
}

}  // namespace swellflow
