// What the outline of an object says of its size and shape; free of LIGGGHTS.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "vector2.h"

namespace swellflow {

/// The vertex of the outline that lies `offset` beyond a ring point, away from the hub.
inline Vector2 outline_point(const Vector2 &from_hub, double offset)
{
  const double distance = from_hub.norm();
  return distance == 0.0 ? from_hub : Vector2(from_hub * (1.0 + offset / distance));
}

struct OutlineShape {
  double area = 0.0;          ///< signed: negative when the outline is turned inside out
  double aspect_ratio = 1.0;  ///< of the ellipse with the same second moments, 1 … 100; a folded outline may have none and counts as 100
  Vector2 centroid = Vector2::Zero();
};

struct PolygonArea {
  double area = 0.0;  ///< signed
  Vector2 centroid = Vector2::Zero();
};

/// Of the closed polygon through `ring`, counter-clockwise, positions relative to any nearby point.
inline PolygonArea polygon_area(const std::vector<Vector2> &ring)
{
  PolygonArea polygon;
  if (ring.empty()) return polygon;
  Vector2 p = ring.back();
  for (const Vector2 &q : ring) {
    const double twice = cross(p, q);
    polygon.area += twice / 2.0;
    polygon.centroid += twice / 6.0 * (p + q);
    p = q;
  }
  polygon.centroid = polygon.area != 0.0 ? Vector2(polygon.centroid / polygon.area) : Vector2(Vector2::Zero());
  return polygon;
}

/// Shape of the same polygon.
inline OutlineShape outline_shape(const std::vector<Vector2> &ring)
{
  const auto [A, centroid] = polygon_area(ring);
  double xx = 0.0, yy = 0.0, xy = 0.0;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const Vector2 &p = ring[k], &q = ring[k + 1 < ring.size() ? k + 1 : 0];
    const double twice = cross(p, q);
    xx += twice / 12.0 * (p.x() * p.x() + p.x() * q.x() + q.x() * q.x());
    yy += twice / 12.0 * (p.y() * p.y() + p.y() * q.y() + q.y() * q.y());
    xy += twice / 24.0 * (2.0 * p.x() * p.y() + p.x() * q.y() + q.x() * p.y() + 2.0 * q.x() * q.y());
  }
  if (A == 0.0) return {};
  xx = xx / A - centroid.x() * centroid.x();
  yy = yy / A - centroid.y() * centroid.y();
  xy = xy / A - centroid.x() * centroid.y();
  const double mean = 0.5 * (xx + yy), spread = std::hypot(0.5 * (xx - yy), xy);
  return {.area = A, .aspect_ratio = mean > spread ? std::min(100.0, std::sqrt((mean + spread) / (mean - spread))) : 100.0, .centroid = centroid};
}

/// Area of the regular polygon with its points on a circle of this diameter.
inline double regular_polygon_area(int points, double diameter)
{
  return points * diameter * diameter / 8.0 * std::sin(2.0 * std::numbers::pi / points);
}

/// Diameter that an object of this shape would have at this area, so that an undeformed one gives its own diameter.
inline double diameter_of_area(double area, double natural_area, double natural_diameter)
{
  return natural_diameter * std::sqrt(std::max(area, 0.0) / natural_area);
}

/// The area V of what fluid an object has taken in follows the area A of its outline as long as that goes towards the natural area A0:
///
///     V -> A, but between V and A0
///
/// An object that is pressed smaller, or pulled larger than it is meant to be, keeps what it has. V is what `inside` was before.
inline double followed_area(double inside, double area, double natural_area)
{
  return std::clamp(area, std::min(inside, natural_area), std::max(inside, natural_area));
}

}  // namespace swellflow
