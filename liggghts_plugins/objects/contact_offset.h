// Where in an object a mass point lies whose sphere is to reach just so far. Free of LIGGGHTS.
#pragma once

#include "contour.h"

namespace swellflow {

/// How far from the contour's vertex, on the way to the hub at the origin, a place lies that has the distance `inset` from the contour: a sphere about it whose radius
/// is larger by `reach` goes beyond the contour by `reach`, and nowhere farther. In a tip that is narrower than the sphere this is as far out as it gets.
/// Throws std::invalid_argument when there is no such place.
double contact_offset(const Contour &contour, const Vector2 &vertex, double inset);

}  // namespace swellflow
