// A vector in the plane of an object.
#pragma once

#include <Eigen/Core>

namespace swellflow {

using Vector2 = Eigen::Vector2d;

inline double cross(const Vector2 &a, const Vector2 &b) { return a.x() * b.y() - a.y() * b.x(); }

}  // namespace swellflow
