// Where fluid appears inside an object that swells and does not drink.
#pragma once

#include <vector>

#include "fluid/grid.h"
#include "liggghts_plugins/objects/vector2.h"

namespace swellflow {

/// Markers ask the fluid for the velocity of the outline, averaged over the reach of their kernel. Were there sources within that reach, the average would be less than the flow that they make: a
/// force would build up that holds growth back, without an end, since no force can change the flow through the outline, which the sources give. So they lie this deep inside, in cells: two for
/// the kernel, one for the cells that share a source. Then what markers are asked for must be that flow: faster by `excess_growth`, since they lie inside the outline.
constexpr double source_depth = 3.0;
/// The outline, relative to the hub, moved inwards by `depth`, but at most by nine tenths.
std::vector<Vector2> shrunk(std::vector<Vector2> outline, double depth);

struct SourcePoint {
  Vec<2> x;
  double share;  ///< of the whole
};

/// Adds points inside the outline, no farther apart than `spacing`, whose shares are the areas that they stand for. The outline's vertices, counter-clockwise, are relative to the hub, from
/// which all of it can be seen; where it is folded, nothing is put. An object without any area has its source at the hub.
void add_source_points(const std::vector<Vector2> &outline, const Vec<2> &hub, double spacing, std::vector<SourcePoint> &points);

}  // namespace swellflow
