// An outline as a file gives it: a table with the columns x and y, one line a vertex. Free of LIGGGHTS.
#pragma once

#include <string>

#include "polygon.h"

namespace swellflow {

/// The vertices in the file's order. Throws std::invalid_argument that names file and line when they are no simple polygon.
Polygon read_outline(const std::string &file, const std::string &text);

}  // namespace swellflow
