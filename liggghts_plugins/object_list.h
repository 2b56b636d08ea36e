// What a create_objects line asks for, as a list of objects; needs no box.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "objects/overlap.h"
#include "objects/shape.h"

namespace swellflow {

struct NewObject {
  Vector2 centre = Vector2::Zero();
  double diameter = 0.0, angle = 0.0, density = 0.0;  ///< angle: in degrees, by which the shape is turned
  std::shared_ptr<const Shape> shape;
  int type = 1;
  std::string place;  ///< in the script or in the file, for messages

  /// A place in the shape, about the object's centre.
  Vector2 placed(const Vector2 &in_shape) const;
  double cds_radius() const { return shape->cds * diameter; }
  Footprint footprint() const;
};

/// Reads `disk ...`, `ellipse ...`, `outline ...`, `lattice ...` or `file ...`. Throws std::invalid_argument. `read_text` gives the contents of a named file.
std::vector<NewObject> read_object_list(int narg, char **arg, const std::function<std::string(const std::string &)> &read_text);

}  // namespace swellflow
