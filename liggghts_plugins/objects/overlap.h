// Which circles overlap, in a box that may be periodic; free of LIGGGHTS.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "disk.h"

namespace swellflow {

struct Circle {
  Vector2 centre;
  double radius;
};

struct PlaneBox {
  Vector2 low, high;
  std::array<bool, 2> periodic{false, false};

  Vector2 length() const { return high - low; }
  /// From b to a by the shortest way.
  Vector2 difference(const Vector2 &a, const Vector2 &b) const;
};

struct Overlap {
  int first, second;  ///< first < second
  double depth;
};

/// The deepest overlap of a circle numbered `first_new` or above with any other; touching is no overlap. Linear in the number of circles.
std::optional<Overlap> deepest_overlap(const std::vector<Circle> &circles, int first_new, const PlaneBox &box);

}  // namespace swellflow
