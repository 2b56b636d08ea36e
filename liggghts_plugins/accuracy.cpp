#include "accuracy.h"

#include "accuracy_budget.h"
#include "domain.h"
#include "fix_fluid_ib.h"
#include "fix_objects.h"
#include "options.h"
#include "say.h"

using namespace LAMMPS_NS;

namespace swellflow {

/// Points on the Pareto front that cases/tradeoff measures; its page is docs/accuracy.md.
const std::vector<AccuracyPreset> &accuracy_presets()
{
  static const std::vector<AccuracyPreset> presets = {
    {.name = "fast", .points = 24, .across = 8, .cfl = 0.8},
    {.name = "balanced", .points = 36, .across = 12, .cfl = 0.6},
    {.name = "accurate", .points = 72, .across = 24, .cfl = 0.4},
  };
  return presets;
}

std::string AccuracyPreset::words() const
{
  return "Accuracy " + name + ": points " + std::to_string(*points) + ", cells auto " + std::to_string(*across) + " across the smallest object, cfl " + shown(*cfl) + " where 'every' is given";
}

namespace {

/// Its defaults would come too late for what is there.
void require_nothing_made(LAMMPS *lmp, const Arguments &line)
{
  const bool objects = find_objects(lmp) != nullptr, fluid = find_fluid(lmp) != nullptr;
  if (objects || fluid)
    line.fail(std::string("it sets defaults of the lines that make objects and the fluid, but there ") + (objects ? "are objects" : "is a fluid") +
              " already: put it above 'create_objects', 'read_restart' and 'fix fluid/ib'");
}

}  // namespace

void accuracy_command(LAMMPS *lmp, int narg, char **arg, AccuracyPreset &preset)
{
  bool report = false;
  or_stop(lmp, [&] {
    Arguments line("accuracy", narg, arg);
    std::vector<std::string> words;
    for (const AccuracyPreset &known : accuracy_presets()) words.push_back(known.name);
    words.push_back("report");
    const std::size_t chosen = line.choice("accuracy", words);
    Options(line.place()).parse(line);
    report = chosen == accuracy_presets().size();
    if (report) return;
    require_nothing_made(lmp, line);
    preset = accuracy_presets()[chosen];
    preset.has_box = lmp->domain->box_exist != 0;
  });
  if (report) print_accuracy_budget(lmp);
  else say(lmp, preset.words());
}

}  // namespace swellflow
