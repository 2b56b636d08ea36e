#include "fix_checkpoint.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <filesystem>

#include "all_ranks.h"
#include "atom.h"
#include "atom_vec.h"
#include "collective.h"
#include "comm.h"
#include "error.h"
#include "fix_contact_history.h"
#include "fix_fluid_ib.h"
#include "force.h"
#include "modify.h"
#include "options.h"
#include "output.h"
#include "restart_lines.h"
#include "update.h"

using namespace LAMMPS_NS;
using namespace swellflow;

FixCheckpoint::FixCheckpoint(LAMMPS *lmp, int narg, char **arg) : Fix(lmp, narg, arg), stop_(lmp)
{
  if (strcmp(id, ID) != 0) error->fix_error(FLERR, this, "this fix is made with the box, under the id 'checkpoint': remove it from the script");
  restart_global = restart_file = restart_peratom = 1;
  nevery = 1;
  // A file that grows too large is to be told as a full disk is, not to end the program.
  std::signal(SIGXFSZ, SIG_IGN);
  constexpr int restart_data = 1;
  atom->add_callback(restart_data);
}

FixCheckpoint::~FixCheckpoint()
{
  constexpr int restart_data = 1;
  atom->delete_callback(id, restart_data);
}

int FixCheckpoint::setmask() { return FixConst::PRE_INITIAL_INTEGRATE | FixConst::END_OF_STEP; }

bool FixCheckpoint::continues() const { return restored_ && state_.in_run != 0.0 && static_cast<bigint>(state_.step) == update->ntimestep; }

void FixCheckpoint::init()
{
  mark_names();
  if (restored_ && static_cast<bigint>(state_.step) == update->ntimestep) {
    update->atime = state_.time;
    update->atimestep = static_cast<bigint>(state_.time_step);
  }
  // Atoms come from the file in the order that they had: sorted anew, forces would be summed up in another.
  if (continues() && atom->sortfreq > 0) {
    sort_every_ = atom->sortfreq;
    atom->sortfreq = 0;
  }
}

void FixCheckpoint::setup(int)
{
  require_fitting_intervals();
  for (const RestartLine &line : restart_lines(*output)) require_writable(line, line.every ? (update->ntimestep / line.every + 1) * line.every : update->ntimestep);
  warn_of_end_within_fluid_step();
  if (continues() && sort_every_ > 0 && force->pair) {
    atom->sortfreq = sort_every_;
    atom->nextsort = static_cast<bigint>(state_.next_sort);
    atom->setup();
  }
  sort_every_ = 0;
  if (source_.fluid_end > source_.fluid_begin && !find_fluid(lmp) && comm->me == 0)
    error->warning(FLERR, ("Restart file '" + source_.name + "' holds a fluid, but the script has none: it is left out").c_str());
  source_ = {};
}

void FixCheckpoint::pre_initial_integrate()
{
  if (!find_fluid(lmp)) stop_.look_now_and_then();
  if (!restored_) return;
  restored_ = false;
  if (state_.in_run != 0.0 && static_cast<bigint>(state_.step) + 1 == update->ntimestep) restore_forces();
}

/* ----------------------------------------------------------------------
   before the file is opened
------------------------------------------------------------------------- */

void FixCheckpoint::mark_names()
{
  for (const RestartLine &line : restart_lines(*output))
    for (char **name : line.names) {
      const std::string given = *name;
      if (given.find('%') != std::string::npos)
        error->all(FLERR, ("restart: a restart file is one file, but the name '" + given + "' has a '%', for one a rank: leave it out").c_str());
      if (is_unfinished(given)) continue;
      const std::string marked = given + unfinished;
      delete[] *name;
      *name = new char[marked.size() + 1];
      strcpy(*name, marked.c_str());
    }
}

void FixCheckpoint::require_fitting_intervals() const
{
  const FixFluidIb *fluid = find_fluid(lmp);
  if (!fluid || fluid->chooses_steps()) return;
  for (const RestartLine &line : restart_lines(*output)) {
    if (line.every == 0) continue;
    const bigint next = (update->ntimestep / line.every + 1) * line.every;
    const int N = fluid->dem_steps_per_step();
    if (line.every % N == 0 && (next - update->ntimestep + fluid->dem_step()) % N == 0) continue;
    error->all(FLERR, ("restart: restart files are written between fluid steps, but 'restart " + std::to_string(line.every) + "' falls within one: fix " + fluid->id +
                       " (fluid/ib) has 'every " + std::to_string(N) + "', and this run begins at step " + std::to_string(update->ntimestep) + ", " +
                       std::to_string(fluid->dem_step()) + " into a fluid step: use a multiple, and runs that are multiples").c_str());
  }
}

void FixCheckpoint::warn_of_end_within_fluid_step() const
{
  const FixFluidIb *fluid = find_fluid(lmp);
  if (!fluid || fluid->chooses_steps() || comm->me != 0) return;
  const int left = (update->laststep - update->ntimestep + fluid->dem_step()) % fluid->dem_steps_per_step();
  if (left == 0) return;
  error->warning(FLERR, ("Fix fluid/ib (id " + std::string(fluid->id) + "): this run ends " + std::to_string(left) + " of " +
                         std::to_string(fluid->dem_steps_per_step()) + " DEM steps into a fluid step: no restart file can be written then").c_str());
}

void FixCheckpoint::require_whole_fluid_step(const std::string &place) const
{
  const FixFluidIb *fluid = find_fluid(lmp);
  if (!fluid || fluid->dem_step() == 0) return;
  error->all(FLERR, (place + ": restart files are written between fluid steps, but step " + std::to_string(update->ntimestep) + " is " +
                     std::to_string(fluid->dem_step()) + " of " + std::to_string(fluid->dem_steps_per_step()) + " DEM steps into one of fix " + fluid->id +
                     " (fluid/ib): let the run end, or the interval be, a multiple of 'every'").c_str());
}

/* ----------------------------------------------------------------------
   LIGGGHTS writes after the end of the step: it would not tell what is to
   be done where it cannot. Tried when a run begins, too, not hours later.
------------------------------------------------------------------------- */

void FixCheckpoint::end_of_step()
{
  stop_.end_run_if_agreed();
  if (next_restart(*output) != update->ntimestep) return;
  for (const RestartLine &line : restart_lines(*output)) require_writable(line, update->ntimestep);
}

void FixCheckpoint::require_writable(const RestartLine &line, bigint step)
{
  for (char **name : line.names) {
    std::string file = *name;
    if (const auto star = file.find('*'); star != std::string::npos) file.replace(star, 1, std::to_string(step));
    require_writable(file);
  }
}

void FixCheckpoint::require_writable(const std::string &file)
{
  try {
    on_rank_0(world, [&] {
      const bool there = std::filesystem::exists(file);
      const int handle = open(file.c_str(), O_WRONLY | O_CREAT, 0666);
      if (handle < 0) throw std::runtime_error(std::strerror(errno));
      close(handle);
      if (!there) unlink(file.c_str());
    });
  } catch (const std::runtime_error &reason) {
    fail(file, reason.what());
  }
}

void FixCheckpoint::fail(const std::string &file, const std::string &reason)
{
  const std::string last = last_good_.empty() ? "this run has written none before" : "the last good one is '" + last_good_ + "'";
  error->all(FLERR, ("restart: the restart file '" + file + "' must be written in full, but could not be (" + reason + "); " + last +
                     ": make room on the disk, or give another folder").c_str());
  throw std::logic_error("unreachable");
}

/* ----------------------------------------------------------------------
   called when LIGGGHTS' own data are being written, and when they are
------------------------------------------------------------------------- */

void FixCheckpoint::write_restart(FILE *fp)
{
  // Between two new neighbour lists what pairs of atoms remember is with the list, not with the atoms; and the room that an atom gets for its contacts,
  // those with a mesh too (contacthistory/mesh), was counted when the last list was made.
  if (!in_command_)
    for (int k = 0; k < modify->nfix; k++)
      if (strncmp(modify->fix[k]->style, "contacthistory", strlen("contacthistory")) == 0) modify->fix[k]->setup_pre_exchange();
  if (comm->me != 0) return;
  const State now{in_command_ ? 0.0 : 1.0, static_cast<double>(update->ntimestep), update->atime, static_cast<double>(update->atimestep),
                  static_cast<double>(atom->nextsort)};
  const int size = sizeof now;
  fwrite(&size, sizeof size, 1, fp);
  fwrite(&now, sizeof now, 1, fp);
}

void FixCheckpoint::restart(char *buffer)
{
  memcpy(&state_, buffer, sizeof state_);
  restored_ = true;
  if (state_.in_run != 0.0 && modify->find_fix(KEPT) < 0) add_column();
}

void FixCheckpoint::write_restart_file(char *name)
{
  const std::string file = name, final_name = is_unfinished(file) ? file.substr(0, file.size() - strlen(unfinished)) : file;
  require_whole_fluid_step("restart");
  const std::vector<int> sizes = from_all_ranks(std::vector<int>{atom->avec->size_restart()}, world);
  try {
    double begin = 0.0;
    on_rank_0(world, [&] {
      require_all_atoms(file, sizes);
      begin = static_cast<double>(std::filesystem::file_size(file));
    });
    FixFluidIb *fluid = find_fluid(lmp);
    if (fluid && fluid->partner()) fluid->partner()->save(file);
    on_rank_0(world, [&] {
      complete_checkpoint(file, static_cast<long>(begin));
      std::filesystem::rename(file, final_name);
      sync_folder(final_name);
    });
  } catch (const std::exception &reason) {
    if (comm->me == 0 && file != final_name) unlink(file.c_str());
    fail(final_name, reason.what());
  }
  last_good_ = final_name;
  if (!in_command_ && atom->sortfreq > 0) atom->setup();  // the bins in which atoms are sorted are as after a set-up
}

/* ----------------------------------------------------------------------
   LIGGGHTS does not look whether its data reached the file. They end with
   the atoms of each rank, led by their number of values.
------------------------------------------------------------------------- */

void FixCheckpoint::require_all_atoms(const std::string &file, const std::vector<int> &sizes) const
{
  const auto bytes_of = [](int n) { return static_cast<long>(sizeof(int)) + n * static_cast<long>(sizeof(double)); };
  long at = static_cast<long>(std::filesystem::file_size(file));
  for (const int size : sizes) at -= bytes_of(size);
  FILE *in = fopen(file.c_str(), "rb");
  bool good = in && at > 0;
  for (const int size : sizes) {
    int found = -1;
    good = good && fseek(in, at, SEEK_SET) == 0 && fread(&found, sizeof found, 1, in) == 1 && found == size;
    at += bytes_of(size);
  }
  if (in) fclose(in);
  if (!good) throw std::runtime_error("it lacks atoms: is the disk full?");
}

/* ---------------------------------------------------------------------- */

FixCheckpoint *LAMMPS_NS::find_checkpoint(LAMMPS *lmp)
{
  const int found = lmp->modify ? lmp->modify->find_fix(FixCheckpoint::ID) : -1;
  return found < 0 ? nullptr : dynamic_cast<FixCheckpoint *>(lmp->modify->fix[found]);
}

FixCheckpoint *LAMMPS_NS::make_checkpoint(LAMMPS *lmp)
{
  if (FixCheckpoint *known = find_checkpoint(lmp)) return known;
  const char *words[] = {FixCheckpoint::ID, "all", "checkpoint"};
  lmp->modify->add_fix(3, const_cast<char **>(words));
  return find_checkpoint(lmp);
}
