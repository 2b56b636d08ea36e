// How LIGGGHTS' unit styles are written into files.
#pragma once

#include <string>

namespace swellflow {

/// Masses, forces and energies are per unit depth, which no name says.
struct UnitNames {
  std::string length, area, time, velocity, spin, mass, force, energy, pressure;  ///< empty: reduced units
};

UnitNames unit_names(const std::string &liggghts_units);

}  // namespace swellflow
