// What a line `fix ID group swell …` says.
#pragma once

#include <limits>
#include <memory>
#include <string>

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

  double clock = 1.0;                ///< how many times as fast as the simulation's the law's time runs

  double swelling_pressure = std::numeric_limits<double>::infinity();  ///< at which a squeezed object stops
  double load_exponent = 1.0;
  bool slowed_by_load() const { return swelling_pressure < std::numeric_limits<double>::infinity(); }

  std::string food;                  ///< the fix fluid/scalar that objects feed on; none: they need no food
  double full = 1.0;                 ///< value of it from which on they swell as the law says
  bool needs_food() const { return !food.empty(); }
  bool has_own_clocks() const { return slowed_by_load() || needs_food(); }
};

/// All that follows `swell`. Throws OptionError on all ranks. Collective.
SwellScript read_swell(LAMMPS_NS::LAMMPS *lmp, Arguments &line);

}  // namespace swellflow
