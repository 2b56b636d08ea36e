// What a create_objects line asks for, as a list of objects; needs no box.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "objects/overlap.h"
#include "objects/packing_room.h"
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

using TextReader = std::function<std::string(const std::string &)>;

inline constexpr double most_objects = 1e7;  ///< of one command

/// An object that is there already.
struct ExistingObject {
  Footprint footprint;
  double reach;  ///< of its contact detection spheres beyond the outline
};

/// What a list may have to know of the scene; only the form `random` asks for the box, regions and objects.
struct ObjectScene {
  int points = ShapeRequest{}.points;  ///< on the ring of an object whose line does not say
  TextReader text_of_file;
  std::function<PlaneBox()> box;
  std::function<std::shared_ptr<const PackingRoom>(const std::string &)> region;  ///< nullptr: there is none of this name
  std::function<std::vector<ExistingObject>()> existing;
  std::function<void(const std::string &place, double points)> require_room;  ///< for so many points, before they are listed
};

struct ObjectList {
  std::vector<NewObject> objects = {};
  std::string remark = "";  ///< what else the user is told of them
  double overlap = 0.0;     ///< by which outlines may
};

/// Reads `disk ...`, `ellipse ...`, `outline ...`, `lattice ...`, `random ...` or `file ...`. Throws std::invalid_argument.
ObjectList read_object_list(int narg, char **arg, const ObjectScene &scene);

}  // namespace swellflow
