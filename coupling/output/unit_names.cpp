// Units of length, mass and time per LIGGGHTS units style; the others follow from them.
#include "coupling/output/unit_names.h"

namespace swellflow {

namespace {

UnitNames derived(const std::string &length, const std::string &mass, const std::string &time, const std::string &force)
{
  return {length, length + "^2", length + "/" + time, mass, force};
}

}  // namespace

UnitNames unit_names(const std::string &units)
{
  if (units == "si") return derived("m", "kg", "s", "N");
  if (units == "cgs") return derived("cm", "g", "s", "dyn");
  if (units == "micro") return derived("um", "pg", "us", "pg um/us^2");
  if (units == "nano") return derived("nm", "ag", "ns", "ag nm/ns^2");
  return {};
}

}  // namespace swellflow
