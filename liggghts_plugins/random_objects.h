// The form `random` of create_objects: a number of objects, or as many as cover a share of the place, that chance puts there.
#pragma once

#include "object_list.h"
#include "options.h"

namespace swellflow {

/// Reads what follows `random` and places the objects. Throws std::invalid_argument, also when they do not fit.
ObjectList read_random_objects(Arguments &line, const ObjectScene &scene);

}  // namespace swellflow
