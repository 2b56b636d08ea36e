// Closed polygons: vertices in order, the last joined to the first. Free of LIGGGHTS.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "vector2.h"

namespace swellflow {

using Polygon = std::vector<Vector2>;

inline std::size_t after(const Polygon &polygon, std::size_t k) { return k + 1 < polygon.size() ? k + 1 : 0; }

/// Mean of r^2 over the area, r from the origin: the square of the radius of gyration.
double mean_square_radius(const Polygon &polygon);

bool contains(const Polygon &polygon, const Vector2 &x);
double distance_to_boundary(const Polygon &polygon, const Vector2 &x);

/// Two edges, each named by its first vertex, that meet where they should not; neighbouring edges do so when they fold back on each other.
std::optional<std::pair<std::size_t, std::size_t>> self_intersection(const Polygon &polygon);

/// How deep one reaches into the other; 0 when they are apart or only touch. Each is given about its own centre, `from_a_to_b` leads from centre to centre.
double overlap_depth(const Polygon &a, const Polygon &b, const Vector2 &from_a_to_b);
/// The same of a polygon and a circle of radius R.
double overlap_depth(const Polygon &a, double R, const Vector2 &from_a_to_b);

}  // namespace swellflow
