// Units of length, mass and time per LIGGGHTS units style; the others follow from them.
#include "unit_names.h"

namespace swellflow {

namespace {

struct Named {
  std::string force, energy, pressure;
};

UnitNames derived(const std::string &length, const std::string &mass, const std::string &time, const Named &named)
{
  return {.length = length, .area = length + "^2", .time = time, .velocity = length + "/" + time, .spin = "rad/" + time,
          .mass = mass, .force = named.force, .energy = named.energy, .pressure = named.pressure};
}

}  // namespace

UnitNames unit_names(const std::string &units)
{
  if (units == "si") return derived("m", "kg", "s", {"N", "J", "Pa"});
  if (units == "cgs") return derived("cm", "g", "s", {"dyn", "erg", "dyn/cm^2"});
  if (units == "micro") return derived("um", "pg", "us", {"pg um/us^2", "pg um^2/us^2", "pg/(um us^2)"});
  if (units == "nano") return derived("nm", "ag", "ns", {"ag nm/ns^2", "ag nm^2/ns^2", "ag/(nm ns^2)"});
  return {};
}

}  // namespace swellflow
