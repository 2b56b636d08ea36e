#include "stop_request.h"

#include <mpi.h>

#include <algorithm>
#include <string>

#include "comm.h"
#include "error.h"
#include "fix_checkpoint.h"
#include "output.h"
#include "restart_lines.h"
#include "signal_handling.h"
#include "update.h"

using namespace LAMMPS_NS;
namespace stop_signals = swellflow::stop_signals;

namespace {

// The interval between looks is doubled below the first and halved above the second, in seconds.
constexpr double often_enough = 0.01, too_seldom = 0.04;
constexpr int longest_interval = 1 << 16;

void say(LAMMPS *lmp, const std::string &line)
{
  if (lmp->comm->me != 0) return;
  for (FILE *out : {lmp->screen, lmp->logfile})
    if (out) fprintf(out, "%s\n", line.c_str());
}

/// Output::request_restart leaves alone what a variable times.
bool has_restart_line(Output &output)
{
  const auto lines = restart_lines(output);
  return std::any_of(lines.begin(), lines.end(), [](const RestartLine &line) { return line.every > 0; });
}

}  // namespace

void StopRequest::look()
{
  const int own = stop_signals::wish();
  int most = 0;
  MPI_Allreduce(&own, &most, 1, MPI_INT, MPI_MAX, lmp_->world);
  if (most != stop_signals::nothing) prepare(static_cast<stop_signals::Wish>(most));
}

void StopRequest::look_now_and_then()
{
  if (--steps_left_ > 0) return;
  const double now = MPI_Wtime(), own = now - last_look_;
  double longest = 0.0;
  MPI_Allreduce(&own, &longest, 1, MPI_DOUBLE, MPI_MAX, lmp_->world);
  last_look_ = now;
  if (longest < often_enough) interval_ = std::min(2 * interval_, longest_interval);
  if (longest > too_seldom) interval_ = std::max(1, interval_ / 2);
  steps_left_ = interval_;
  look();
}

/* ----------------------------------------------------------------------
   Before neighbour lists are looked at: a restart file needs new ones.
   LIGGGHTS is told to quit only at the end of the step, since it would
   print thermo output for which it has not summed up energies.
------------------------------------------------------------------------- */

void StopRequest::prepare(stop_signals::Wish wish)
{
  using namespace SignalHandler;
  stop_signals::agreed(wish);
  stopping_ = wish == stop_signals::save_and_stop;
  Output &output = *lmp_->output;
  const bool lines = has_restart_line(output);
  if (enable_restart_writing && (stopping_ || lines)) {
    // After a file under LIGGGHTS' own name its calendar of restart files is as it was, which going on needs.
    if (stopping_ && lines) {
      output.request_restart(lmp_->update->ntimestep);
      output.next = lmp_->update->ntimestep;
    } else {
      request_write_restart = true;
    }
  }
  say(lmp_, "A signal came: " + std::string(stopping_ ? "the run ends" : "a restart file is written") + " after step " + std::to_string(lmp_->update->ntimestep));
}

void StopRequest::end_run_if_agreed()
{
  if (stopping_) SignalHandler::request_quit = true;
}

bool LAMMPS_NS::report_stop(LAMMPS *lmp)
{
  if (!SignalHandler::request_quit) return false;
  const FixCheckpoint *checkpoint = find_checkpoint(lmp);
  const std::string file = checkpoint ? checkpoint->last_good() : "";
  say(lmp, "Stopped by a signal at step " + std::to_string(lmp->update->ntimestep) + (file.empty() ? "; no restart file was to be written" : "; restart file: " + file));
  return true;
}
