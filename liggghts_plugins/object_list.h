// What a create_objects line asks for, as a list of objects; needs no box.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "objects/disk.h"

namespace swellflow {

struct NewObject {
  Vector2 centre;
  Disk disk;
  int type = 1;
  std::string place;  ///< in the script or in the file, for messages
};

/// Reads `disk ...`, `lattice ...` or `file ...`. Throws std::invalid_argument. `read_text` gives the contents of a named file.
std::vector<NewObject> read_object_list(int narg, char **arg, const std::function<std::string(const std::string &)> &read_text);

}  // namespace swellflow
