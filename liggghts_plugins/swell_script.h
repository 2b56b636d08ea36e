// What a line `fix ID group swell …` says.
#pragma once

#include <limits>
#include <memory>

#include "objects/swelling_laws.h"
#include "script_value.h"

namespace LAMMPS_NS {
class LAMMPS;
}

namespace swellflow {

class Arguments;

struct SwellScript {
  std::unique_ptr<SwellingLaw> law;  ///< none: the variable `size` says it
  ScriptValue size;
  bool size_is_ratio = false;        ///< to the diameter at creation; else the diameter itself

  bool absorb = true;
  bool drinks = false;               ///< the mass grows by that of the water, not at constant density
  double water_density = 0.0;

  double rate_scatter = 0.0, size_scatter = 0.0;  ///< relative standard deviations between objects
  int seed = 0;

  double swelling_pressure = std::numeric_limits<double>::infinity();  ///< at which a squeezed object stops
  double load_exponent = 1.0;
  bool slowed_by_load() const { return swelling_pressure < std::numeric_limits<double>::infinity(); }
};

/// All that follows `swell`. Throws OptionError on all ranks. Collective.
SwellScript read_swell(LAMMPS_NS::LAMMPS *lmp, Arguments &line);

}  // namespace swellflow
