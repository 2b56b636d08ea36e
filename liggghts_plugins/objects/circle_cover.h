// Circles that together cover an outline, so that outlines of any shape can be kept apart as circles are. Free of LIGGGHTS.
#pragma once

#include <vector>

#include "overlap.h"

namespace swellflow {

/// Every place in the polygon lies in one of these circles, and none reaches more than `tolerance` beyond it.
std::vector<Circle> covering_circles(const Polygon &outline, double tolerance);

}  // namespace swellflow
