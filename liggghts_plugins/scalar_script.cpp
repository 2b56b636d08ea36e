#include "scalar_script.h"

#include "domain.h"
#include "lammps.h"
#include "options.h"
#include "region.h"

using LAMMPS_NS::LAMMPS;

namespace swellflow {

namespace {

const std::vector<std::string> side_names = {"xlo", "xhi", "ylo", "yhi"};

}  // namespace

ScalarScript::ScalarScript(Arguments &line) : place_(line.place())
{
  Options options(place_);
  options.number("diffusivity", diffusivity_, Range::not_negative(), "length^2/time", "of the scalar in the fluid").required();
  options.number("initial", initial_, Range::any(), "", "value of all fluid at the start");
  options.custom("region", [this](Arguments &words) {
    const std::string region = words.word("region");
    parts_.push_back({region, words.number("region " + region)});
  }, "REGION-ID C: value within a region at the start").repeatable();
  options.custom("feed", [this](Arguments &words) { read_side(words, "feed", ScalarSideKind::feed); }, "SIDE C: value of what flows in there").repeatable();
  options.custom("value", [this](Arguments &words) { read_side(words, "value", ScalarSideKind::value); }, "SIDE C: value on the side").repeatable();
  options.number("uptake", uptake_, Range::not_negative(), "", "amount that objects take, per area that they drink");
  options.parse(line);
}

void ScalarScript::read_side(Arguments &line, const std::string &keyword, ScalarSideKind kind)
{
  const int side = line.choice(keyword, side_names);
  if (sides_[side] != ScalarSideKind::open) line.fail("each side is described once, but " + side_names[side] + " is here twice: take one of them out");
  sides_[side] = kind;
  side_value_[side] = ScriptValue::read(line, keyword + " " + side_names[side], "the scalar's");
}

// ---- rules -----------------------------------------------------------------------------------------------------------------------------------

/// Nothing, or rule, value and remedy.
std::string ScalarScript::what_is_wrong_with(int side, SideKind fluid_side) const
{
  const bool closed = fluid_side == SideKind::wall || fluid_side == SideKind::slip, inflow = fluid_side == SideKind::inflow || fluid_side == SideKind::parabolic_inflow;
  const std::string name = side_names[side];
  if (sides_[side] == ScalarSideKind::feed && closed)
    return "'feed' says what the flow brings in through a side, but nothing flows through " + name + ": use 'value " + name + " C', or leave it out";
  if (sides_[side] == ScalarSideKind::value && fluid_side == SideKind::periodic)
    return "a value is held on a side at which the fluid ends, but " + name + " is periodic: use 'feed " + name + " C', or leave it out";
  if (sides_[side] == ScalarSideKind::open && inflow)
    return "what an inflow brings must be known, but nothing is said of " + name + ": add 'feed " + name + " C' or 'value " + name + " C'";
  return "";
}

void ScalarScript::require(LAMMPS *lmp, const std::array<SideKind, N_SIDES> &fluid_sides) const
{
  for (int side = 0; side < N_SIDES; side++) {
    const std::string problem = what_is_wrong_with(side, fluid_sides[side]);
    if (!problem.empty()) throw OptionError(place_ + ": " + problem);
    side_value_[side].require(lmp);
  }
  for (const Part &part : parts_)
    if (lmp->domain->find_region(part.region.c_str()) < 0)
      throw OptionError(place_ + ": 'region' must name a region, but there is no region '" + part.region + "': define it above, or change the name");
}

// ---- values ----------------------------------------------------------------------------------------------------------------------------------

std::function<double(const Triple &)> ScalarScript::initial(LAMMPS *lmp) const
{
  std::vector<std::pair<LAMMPS_NS::Region *, double>> parts;
  for (const Part &part : parts_) {
    parts.emplace_back(lmp->domain->regions[lmp->domain->find_region(part.region.c_str())], part.value);
    parts.back().first->prematch();
  }
  return [parts, everywhere = initial_](const Triple &x) {
    double value = everywhere;
    for (const auto &[region, inside] : parts)
      if (region->match(x[0], x[1], x[2])) value = inside;
    return value;
  };
}

bool ScalarScript::varies() const
{
  bool varies = false;
  for (const ScriptValue &value : side_value_) varies = varies || value.is_variable();
  return varies;
}

std::array<double, 6> ScalarScript::side_values(LAMMPS *lmp) const
{
  std::array<double, 6> values{};
  for (int side = 0; side < N_SIDES; side++) values[side] = side_value_[side].evaluate(lmp);
  return values;
}

}  // namespace swellflow
