#include "swell_script.h"

#include <functional>
#include <map>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "lammps.h"
#include "objects/csv_table.h"
#include "options.h"
#include "text_file.h"
#include "update.h"

using LAMMPS_NS::LAMMPS;

namespace swellflow {

namespace {

/// A law reads the words behind its name, and declares its keywords; when the line has been read, `make` gives the law.
using MakeLaw = std::function<std::unique_ptr<SwellingLaw>()>;

/// What the keywords of the laws fill.
struct LawValues {
  double rate = 0.0, smallest = 0.0, largest = 0.0;         // linear
  std::vector<double> coefficients;                         // polynomial
  double until = 0.0;
  int kind = 0;
  int form = 0;                                             // hydrogel
  double millimetre = 0.0, second = 0.0;
  double final = 0.0, tau = 0.0, diffusivity = 0.0;         // tanaka_fillmore
};

MakeLaw linear(Arguments &line, Options &options, LawValues &v)
{
  options.number("rate", v.rate, Range::any(), "diameter per time", "growth of the natural diameter").required();
  options.number("max", v.largest, Range::positive(), "length", "natural diameter at which growth ends");
  options.number("min", v.smallest, Range::positive(), "length", "natural diameter at which shrinking ends");
  return [&line, &options, &v] {
    const std::string end = v.rate < 0.0 ? "min" : "max", other = v.rate < 0.0 ? "max" : "min";
    const std::string rule = std::string("a rate ") + (v.rate < 0.0 ? "< 0" : ">= 0") + " ends at '" + end + "', but ";
    if (!options.given(end)) line.fail(rule + "'" + end + "' is missing: add '" + end + "' with a number > 0 (length)");
    if (options.given(other)) line.fail(rule + "'" + other + "' is given: remove it");
    return std::make_unique<LinearSwelling>(v.rate, v.rate < 0.0 ? v.smallest : v.largest);
  };
}

MakeLaw polynomial(Arguments &line, Options &options, LawValues &v)
{
  v.coefficients.push_back(line.number("polynomial"));
  while (line.next_is_number()) v.coefficients.push_back(line.number("polynomial"));
  options.number("until", v.until, Range::positive(), "time", "time from which the size stays").required();
  options.choice("gives", v.kind, {"diameter", "ratio"}, "what the polynomial is: the diameter, or its ratio to that at the start");
  return [&v] { return std::make_unique<PolynomialSwelling>(static_cast<SizeKind>(v.kind), v.coefficients, v.until); };
}

/// A millimetre and a second in the units of the script, where these say it.
std::pair<double, double> millimetre_and_second(const LAMMPS *lmp)
{
  static const std::map<std::string, std::pair<double, double>> known = {
      {"si", {1e-3, 1.0}}, {"cgs", {0.1, 1.0}}, {"micro", {1e3, 1e6}}, {"nano", {1e6, 1e9}}};
  const auto found = known.find(lmp->update->unit_style);
  return found == known.end() ? std::pair{0.0, 0.0} : found->second;
}

MakeLaw hydrogel(const LAMMPS *lmp, Arguments &line, Options &options, LawValues &v)
{
  v.form = line.choice("hydrogel", {"printed", "reconstructed"});
  std::tie(v.millimetre, v.second) = millimetre_and_second(lmp);
  options.number("millimetre", v.millimetre, Range::positive(), "length", "a millimetre in the unit of length of the script");
  if (v.millimetre == 0.0) options.required();
  options.number("second", v.second, Range::positive(), "time", "a second in the unit of time of the script");
  if (v.second == 0.0) options.required();
  return [&v] {
    return std::make_unique<PolynomialSwelling>(hydrogel_swelling(static_cast<HydrogelForm>(v.form), v.millimetre, v.second));
  };
}

std::unique_ptr<SwellingLaw> table_law(const std::string &name, const std::string &text)
{
  const CsvTable table(name, text, {"time", "diameter", "ratio"});
  if (!table.has("time") || table.has("diameter") == table.has("ratio"))
    throw OptionError(name + ": the columns must be time and either diameter or ratio: correct the first line");
  const std::string column = table.has("ratio") ? "ratio" : "diameter";
  std::vector<double> times, sizes;
  for (const CsvTable::Row &row : table.rows()) {
    const double time = *table.value(row, "time"), size = *table.value(row, column);
    if (!times.empty() && time <= times.back())
      throw OptionError(table.place(row) + ": times must ascend, but " + shown(time) + " follows " + shown(times.back()) + ": sort the lines");
    if (size <= 0.0) throw OptionError(table.place(row) + ": '" + column + "' must be > 0, but is " + shown(size) + ": change it");
    times.push_back(time);
    sizes.push_back(size);
  }
  if (times.size() < 2) throw OptionError(name + ": a law needs the size at two times or more, but there is one: add lines");
  return std::make_unique<TableSwelling>(column == "ratio" ? SizeKind::ratio : SizeKind::diameter, MonotoneCurve(times, sizes));
}

MakeLaw table(LAMMPS *lmp, Arguments &line)
{
  const std::string name = line.word("table");
  return [lmp, name, place = line.place() + " table"] { return table_law(place + " " + name, text_of_file(lmp, place, name)); };
}

MakeLaw tanaka_fillmore(Arguments &line, Options &options, LawValues &v)
{
  options.number("final", v.final, Range::positive(), "length, or none", "natural diameter at the end, or its ratio to that at the start").required();
  options.choice("gives", v.kind, {"diameter", "ratio"}, "what 'final' is: the diameter, or its ratio to that at the start");
  options.number("tau", v.tau, Range::positive(), "time", "time constant of the slowest part");
  options.number("diffusivity", v.diffusivity, Range::positive(), "area per time", "cooperative diffusion coefficient of the gel");
  return [&line, &options, &v] {
    if (options.given("tau") == options.given("diffusivity"))
      line.fail(std::string("the speed must be given once, but 'tau' and 'diffusivity' are ") + (options.given("tau") ? "both given: keep one of them"
                                                                                                                       : "both missing: add one of them"));
    const auto kind = static_cast<SizeKind>(v.kind);
    return std::make_unique<TanakaFillmoreSwelling>(options.given("tau") ? TanakaFillmoreSwelling::with_tau(kind, v.final, v.tau)
                                                                        : TanakaFillmoreSwelling::with_diffusivity(kind, v.final, v.diffusivity));
  };
}

void read_variable(Arguments &line, SwellScript &script)
{
  const std::string given = line.empty() ? "" : line.peek();
  if (given.rfind("v_", 0) != 0) line.fail("the size must be an equal-style variable written v_NAME, but is '" + given + "': change it");
  script.size = ScriptValue::read(line, script.size_is_ratio ? "ratio" : "diameter", script.size_is_ratio ? "swelling ratio" : "length");
}

/// Keywords of all laws.
void declare(Options &options, SwellScript &script, int &mass)
{
  options.yes_no("absorb", script.absorb, "whether the objects drink the fluid that they grow by");
  options.choice("mass", mass, {"constant_density", "drink"}, "how the mass follows the size");
  options.number("water_density", script.water_density, Range::positive(), "density", "of what an object drinks");
  options.custom(
      "scatter",
      [&script](Arguments &line) {
        script.rate_scatter = line.number("scatter, rate", Range::not_negative());
        script.size_scatter = line.number("scatter, size", Range::not_negative());
      },
      "relative standard deviations of speed and growth between objects");
  options.integer("seed", script.seed, Range::not_negative(), "of the scatter");
  options.number("clock", script.clock, Range::positive(), "", "how many times as fast as the simulation's the law's time runs");
  options.number("load", script.swelling_pressure, Range::positive(), "pressure", "contact pressure at which swelling stops");
  options.number("exponent", script.load_exponent, Range::positive(), "", "of the slowing by load");
  options.text("fed_by", script.food, "fix fluid/scalar whose value at the outline an object needs to swell");
  options.number("full", script.full, Range::positive(), "", "value from which on it swells as the law says");
}

void require_partner(const Arguments &line, const Options &options, const std::string &keyword, const std::string &partner)
{
  if (options.given(keyword) && !options.given(partner))
    line.fail("'" + keyword + "' needs '" + partner + "', which is missing: add it, or remove '" + keyword + "'");
}

void check(const Arguments &line, const Options &options, const SwellScript &script)
{
  require_partner(line, options, "scatter", "seed");
  require_partner(line, options, "seed", "scatter");
  require_partner(line, options, "exponent", "load");
  require_partner(line, options, "full", "fed_by");
  if (script.drinks && !options.given("water_density")) line.fail("'mass drink' needs 'water_density', which is missing: add it");
  if (!script.drinks && options.given("water_density")) line.fail("'water_density' belongs to 'mass drink': add that, or remove 'water_density'");
  if (script.law) return;
  const std::string rule = ", but variable '" + script.size.variable() + "' gives one size for all at a time: remove ";
  if (script.rate_scatter > 0.0) line.fail("scatter of the rate needs a clock for each object" + rule + "it: 'scatter 0 SIZE'");
  if (options.given("clock")) line.fail("'clock' needs a law with a time of its own" + rule + "'clock', and let the formula run faster");
  if (script.slowed_by_load()) line.fail("'load' needs a clock for each object" + rule + "'load'");
  if (script.needs_food()) line.fail("'fed_by' needs a clock for each object" + rule + "'fed_by'");
}

}  // namespace

SwellScript read_swell(LAMMPS *lmp, Arguments &line)
{
  enum { LINEAR, POLYNOMIAL, HYDROGEL, TABLE, TANAKA_FILLMORE, DIAMETER, RATIO };
  const int law = line.choice("law", {"linear", "polynomial", "hydrogel", "table", "tanaka_fillmore", "diameter", "ratio"});
  SwellScript script;
  Options options(line.place());
  LawValues values;
  MakeLaw make = [] { return nullptr; };
  switch (law) {
    case LINEAR: make = linear(line, options, values); break;
    case POLYNOMIAL: make = polynomial(line, options, values); break;
    case HYDROGEL: make = hydrogel(lmp, line, options, values); break;
    case TABLE: make = table(lmp, line); break;
    case TANAKA_FILLMORE: make = tanaka_fillmore(line, options, values); break;
    default:
      script.size_is_ratio = law == RATIO;
      read_variable(line, script);
  }
  int mass = 0;
  declare(options, script, mass);
  options.parse(line);
  script.drinks = mass == 1;
  script.law = make();
  check(line, options, script);
  return script;
}

}  // namespace swellflow
