// How the mass of an object is shared among its points, so that they move as the solid shape would. Free of LIGGGHTS.
#pragma once

#include <vector>

#include "shape.h"

namespace swellflow {

/// Masses of the ring points over their mean: each in proportion to its part of the outline, w_k, times 1 + a . x_k with the a that puts their centre of mass at the origin:
/// of all changes with sum w_k (change_k)^2 least. Throws std::invalid_argument when a point would get next to nothing.
std::vector<double> centred_weights(const std::vector<Shape::RingPoint> &ring, const Polygon &outline);

/// The part of the mass that the hub must have for the moment of inertia to be that of the solid shape, M * mean_square_radius: the hub, at the centroid, adds nothing, so
/// that (1 - share) * sum w_k x_k^2 / N is that. Throws std::invalid_argument when the ring is too far inside for it.
double hub_share_for_inertia(const Shape &shape);

}  // namespace swellflow
