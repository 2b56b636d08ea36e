// Which objects overlap, in a box that may be periodic; free of LIGGGHTS.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <vector>

#include "polygon.h"

namespace swellflow {

struct Circle {
  Vector2 centre;
  double radius;
};

/// What an object covers: the polygon, given about the centre of the circle that holds it; none: the circle itself.
struct Footprint {
  Circle circle;
  Polygon outline;
};

struct PlaneBox {
  Vector2 low, high;
  std::array<bool, 2> periodic{false, false};

  Vector2 length() const { return high - low; }
  /// From b to a by the shortest way.
  Vector2 difference(const Vector2 &a, const Vector2 &b) const;
  /// The image that lies in the box where it is periodic.
  Vector2 wrapped(Vector2 x) const;
};

struct Overlap {
  int first, second;  ///< first < second
  double depth;
};

/// visit(i, j, way from i to j), i < j, for the pairs of circles that overlap of which one is numbered `first_new` or above; touching is no overlap. Linear in the
/// number of circles.
void for_each_overlapping_pair(const std::vector<Circle> &circles, int first_new, const PlaneBox &box,
                               const std::function<void(int, int, const Vector2 &)> &visit);

/// The deepest overlap of an object numbered `first_new` or above with any other.
std::optional<Overlap> deepest_overlap(const std::vector<Footprint> &objects, int first_new, const PlaneBox &box);

}  // namespace swellflow
