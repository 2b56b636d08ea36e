// How LIGGGHTS' unit styles are written into the files.
#pragma once

#include <string>

namespace swellflow {

struct UnitNames {
  std::string length, area, velocity, mass, force;  ///< empty: reduced units
};

UnitNames unit_names(const std::string &liggghts_units);

}  // namespace swellflow
