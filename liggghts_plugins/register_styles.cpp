// The styles are entries of two maps from a style's name to a creator, Modify::fix_map and Input::command_map, which
// LIGGGHTS fills when it starts. A creator is a plain function: it gets the LAMMPS object and nothing else. So what our
// fixes need from outside (Factories) is carried by the object that reads the script, which the creator finds in lmp->input.
#include "register_styles.h"

#include <cstring>
#include <map>
#include <stdexcept>

#include "accuracy_budget.h"
#include "accuracy.h"
#include "checkpoint_commands.h"
#include "create_objects.h"
#include "fix.h"
#include "fix_checkpoint.h"
#include "fix_fluid_ib.h"
#include "fix_fluid_scalar.h"
#include "fix_guard.h"
#include "fix_lubrication_cds.h"
#include "fix_mass_spring.h"
#include "fix_nve_cds_implicit.h"
#include "fix_objects.h"
#include "fix_output_objects.h"
#include "fix_output_vtk.h"
#include "fix_prescribed.h"
#include "fix_rigid_cds.h"
#include "fix_swell.h"
#include "input.h"
#include "lammps.h"
#include "liggghts_version.h"
#include "modify.h"
#include "universe.h"

using namespace LAMMPS_NS;

namespace swellflow {

namespace {

using FixCreator = Fix *(*)(LAMMPS *, int, char **);
using FixMap = std::map<std::string, FixCreator>;
using CommandCreator = void (*)(LAMMPS *, int, char **);
using CommandMap = std::map<std::string, CommandCreator>;

// Modify::fix_map is private. Access is not checked in an explicit instantiation ([temp.spec.general]), so its address may
// be a template argument there, and the friend defined along with it may use it.
FixMap *fix_map_of(const Modify &);
template <FixMap *Modify::*Member>
struct FixMapAccess {
  friend FixMap *fix_map_of(const Modify &modify) { return modify.*Member; }
};
template struct FixMapAccess<&Modify::fix_map>;

const Factories &factories_of(LAMMPS *lmp);
AccuracyPreset &accuracy_of(LAMMPS *lmp);

template <typename T>
Fix *create_fix(LAMMPS *lmp, int narg, char **arg)
{
  return new T(lmp, narg, arg);
}

const FixMap &fix_styles()
{
  static const FixMap styles = {
    {"objects", create_fix<FixObjects>},
    {"checkpoint", create_fix<FixCheckpoint>},
    {"guard", create_fix<FixGuard>},
    {"mass_spring", create_fix<FixMassSpring>},
    {"swell", create_fix<FixSwell>},
    {"nve/cds", create_nve_cds},
    {"rigid/cds", create_fix<FixRigidCds>},
    {"lubrication/cds", create_fix<FixLubricationCds>},
    {"held", create_fix<FixPrescribed>},
    {"prescribed", create_fix<FixPrescribed>},
    {"fluid/ib", [](LAMMPS *lmp, int narg, char **arg) -> Fix * { return new FixFluidIb(lmp, narg, arg, factories_of(lmp).fluid, accuracy_of(lmp)); }},
    {"fluid/scalar", create_fix<FixFluidScalar>},
    {"output/objects", create_fix<FixOutputObjects>},
    {"output/vtk", [](LAMMPS *lmp, int narg, char **arg) -> Fix * { return new FixOutputVtk(lmp, narg, arg, factories_of(lmp).output); }},
  };
  return styles;
}

const CommandMap &commands()
{
  static const CommandMap map = {
    {"create_objects", [](LAMMPS *lmp, int narg, char **arg) { CreateObjects(lmp, accuracy_of(lmp).points.value_or(ShapeRequest{}.points)).command(narg, arg); }},
    {"accuracy", [](LAMMPS *lmp, int narg, char **arg) { accuracy_command(lmp, narg, arg, accuracy_of(lmp)); }},
    {"guard", set_guard},
  };
  return map;
}

/// A map of another size, or without these names, is not the map that we take it for.
template <typename Map>
void check(const Map *map, size_t least, size_t most, std::initializer_list<const char *> names, const std::string &what)
{
  const std::string remedy = ": this program was built for another LIGGGHTS than the one it found; rebuild it against Debian's "
                             "libliggghts-dev " + std::string(supported_liggghts);
  if (map == nullptr || map->size() < least || map->size() > most)
    throw std::runtime_error("LIGGGHTS' table of " + what + " must hold " + std::to_string(least) + " to " + std::to_string(most) +
                             " entries but holds " + std::to_string(map ? map->size() : 0) + remedy);
  for (const char *name : names)
    if (map->count(name) == 0) throw std::runtime_error("LIGGGHTS' table of " + what + " does not know '" + name + "'" + remedy);
}

/// Reads the script as LIGGGHTS does, carries the factories, and registers the fix styles again after `clear`, which rebuilds
/// their map. No fix of ours may come before a box exists, and only three commands make one: they are where we step in.
class ScriptReader : public Input {
public:
  ScriptReader(LAMMPS *lmp, const Factories &factories) : Input(lmp, 0, nullptr), factories_(factories)
  {
    command = nullptr;
    check(command_map, 15, 60, {"run", "set", "velocity"}, "commands");
    for (const auto &[name, creator] : commands()) (*command_map)[name] = creator;
    for (const char *name : {"create_box", "read_data", "read_restart"}) {
      stock_[name] = command_map->at(name);
      (*command_map)[name] = with_fix_styles;
    }
    stock_["write_restart"] = command_map->at("write_restart");
    (*command_map)["write_restart"] = write_restart;
    stock_["run"] = command_map->at("run");
    (*command_map)["run"] = run;
  }

  /// Variables and echo settings of the command line live in the reader that LIGGGHTS made when it started.
  void take_settings(Input &from)
  {
    std::swap(variable, from.variable);
    echo_screen = from.*(&ScriptReader::echo_screen);
    echo_log = from.*(&ScriptReader::echo_log);
    seed_check_error = from.*(&ScriptReader::seed_check_error);
  }

  void set_factories(const Factories &factories) { factories_ = factories; }
  const Factories &factories() const { return factories_; }
  GuardMode &guard_mode() { return guard_mode_; }
  AccuracyPreset &accuracy() { return accuracy_; }
  std::string command_name() const { return command ? command : ""; }

private:
  static void with_fix_styles(LAMMPS *lmp, int narg, char **arg);
  static void write_restart(LAMMPS *lmp, int narg, char **arg);
  static void run(LAMMPS *lmp, int narg, char **arg);
  StockCommand stock(LAMMPS *lmp) const
  {
    return [lmp, own = stock_.at(command)](int narg, char **arg) { own(lmp, narg, arg); };
  }

  Factories factories_;
  GuardMode guard_mode_ = GuardMode::refuse;
  AccuracyPreset accuracy_;
  std::map<std::string, CommandCreator> stock_;
};

void add_fix_styles(LAMMPS *lmp)
{
  FixMap *map = fix_map_of(*lmp->modify);
  check(map, 100, 1000, {"property/atom", "property/global", "wall/gran"}, "fix styles");
  for (const auto &[name, creator] : fix_styles()) (*map)[name] = creator;
}

void ScriptReader::with_fix_styles(LAMMPS *lmp, int narg, char **arg)
{
  add_fix_styles(lmp);
  auto *reader = dynamic_cast<ScriptReader *>(lmp->input);
  if (reader->accuracy_.has_box) reader->accuracy_ = {};
  reader->accuracy_.has_box = true;
  if (std::strcmp(reader->command, "read_restart") == 0) {
    read_checkpoint(lmp, narg, arg, reader->stock(lmp));
  } else {
    reader->stock(lmp)(narg, arg);
    make_checkpoint(lmp);
  }
  make_guard(lmp);
}

void ScriptReader::write_restart(LAMMPS *lmp, int narg, char **arg)
{
  write_checkpoint(lmp, narg, arg, dynamic_cast<ScriptReader *>(lmp->input)->stock(lmp));
}

/// The accuracy budget belongs to what LIGGGHTS prints after a run, and is left out with that.
void ScriptReader::run(LAMMPS *lmp, int narg, char **arg)
{
  bool post = true;
  for (int k = 1; k + 1 < narg && std::strcmp(arg[k], "every") != 0; ++k)
    if (std::strcmp(arg[k], "post") == 0) post = std::strcmp(arg[k + 1], "no") != 0;
  dynamic_cast<ScriptReader *>(lmp->input)->stock(lmp)(narg, arg);
  if (post) print_accuracy_budget(lmp);
}

const Factories &factories_of(LAMMPS *lmp)
{
  return dynamic_cast<ScriptReader &>(*lmp->input).factories();
}

AccuracyPreset &accuracy_of(LAMMPS *lmp)
{
  return dynamic_cast<ScriptReader &>(*lmp->input).accuracy();
}

template <typename Map>
std::vector<std::string> names(const Map &map)
{
  std::vector<std::string> result;
  for (const auto &entry : map) result.push_back(entry.first);
  return result;
}

}  // namespace

void register_styles(LAMMPS *lmp, const Factories &factories)
{
  check_version(*lmp->universe);
  mark_version(*lmp->universe);
  if (auto *reader = dynamic_cast<ScriptReader *>(lmp->input)) {
    reader->set_factories(factories);
  } else {
    auto *new_reader = new ScriptReader(lmp, factories);
    new_reader->take_settings(*lmp->input);
    delete lmp->input;
    lmp->input = new_reader;
  }
  add_fix_styles(lmp);
}

std::string command_of(const LAMMPS *lmp)
{
  const auto *reader = dynamic_cast<const ScriptReader *>(lmp->input);
  return reader ? reader->command_name() : "";
}

GuardMode &guard_mode(LAMMPS *lmp) { return dynamic_cast<ScriptReader &>(*lmp->input).guard_mode(); }

std::vector<std::string> our_fix_styles()
{
  std::vector<std::string> styles = names(fix_styles());
  std::erase_if(styles, [](const std::string &style) { return style == FixObjects::ID || style == FixCheckpoint::ID || style == FixGuard::ID; });
  return styles;
}

std::vector<std::string> our_commands() { return names(commands()); }

}  // namespace swellflow
