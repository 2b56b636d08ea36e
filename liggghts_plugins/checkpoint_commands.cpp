#include "checkpoint_commands.h"

#include <string>

#include "checkpoint_file.h"
#include "collective.h"
#include "comm.h"
#include "error.h"
#include "fix_checkpoint.h"
#include "liggghts_version.h"
#include "options.h"
#include "say.h"
#include "universe.h"
#include "update.h"

using namespace LAMMPS_NS;

namespace swellflow {

namespace {

/// The one name on the line.
std::string name_on(const std::string &command, LAMMPS *lmp, int narg, char **arg)
{
  std::string name;
  or_stop(lmp, [&] {
    if (narg != 1)
      throw OptionError(command + ": a restart file is the whole scene, under one name, but the line has " + std::to_string(narg) + " words: give the name alone");
    name = arg[0];
    if (name.find('%') != std::string::npos)
      throw OptionError(command + ": a restart file is one file, but the name '" + name + "' has a '%', for one a rank: leave it out");
    if (is_unfinished(name)) throw OptionError(command + ": '" + name + "' is what unfinished files are called: use another name than one that ends with '.writing'");
  });
  return name;
}

/// Rank 0 looks, all know.
CheckpointFile found_file(LAMMPS *lmp, const std::string &name)
{
  CheckpointFile file;
  try {
    on_rank_0(lmp->world, [&] {
      file = name.find('*') == std::string::npos ? checked_checkpoint(name) : newest_checkpoint(name, [&](const std::string &reason) {
        lmp->error->warning(FLERR, ("read_restart: " + reason).c_str());
      });
    });
  } catch (const std::runtime_error &reason) {
    lmp->error->all(FLERR, (std::string("read_restart: ") + reason.what()).c_str());
  }
  long numbers[4] = {static_cast<long>(file.name.size()), file.fluid_begin, file.fluid_end, file.checked};
  MPI_Bcast(numbers, 4, MPI_LONG, 0, lmp->world);
  file.name.resize(numbers[0]);
  MPI_Bcast(file.name.data(), static_cast<int>(numbers[0]), MPI_CHAR, 0, lmp->world);
  return {.name = file.name, .fluid_begin = numbers[1], .fluid_end = numbers[2], .checked = numbers[3] != 0};
}

}  // namespace

void write_checkpoint(LAMMPS *lmp, int narg, char **arg, const StockCommand &stock)
{
  std::string name = name_on("write_restart", lmp, narg, arg);
  FixCheckpoint *checkpoint = find_checkpoint(lmp);
  if (!checkpoint) return stock(narg, arg);  // there is no box, as it will say
  checkpoint->require_whole_fluid_step("write_restart");
  if (const auto star = name.find('*'); star != std::string::npos) name.replace(star, 1, std::to_string(lmp->update->ntimestep));
  name += unfinished;
  char *words[] = {name.data()};
  checkpoint->begin_command(name);
  stock(1, words);
  checkpoint->end_command();
}

void read_checkpoint(LAMMPS *lmp, int narg, char **arg, const StockCommand &stock)
{
  CheckpointFile file = found_file(lmp, name_on("read_restart", lmp, narg, arg));
  // LIGGGHTS warns when the version in the file is not its own.
  if (!file.checked) unmark_version(*lmp->universe);
  char *words[] = {file.name.data()};
  stock(1, words);
  mark_version(*lmp->universe);
  say(lmp, !file.checked ? "  restart file of LIGGGHTS itself: no checksum, no fluid"
                         : "  " + file.name + ": complete" + (file.fluid_end > file.fluid_begin ? ", with a fluid" : ", without a fluid"));
  make_checkpoint(lmp)->set_source(file);
}

}  // namespace swellflow
