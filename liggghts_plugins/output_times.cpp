#include "output_times.h"

#include <cstring>

#include "comm.h"
#include "fix_checkpoint.h"
#include "lammps.h"
#include "update.h"

using namespace LAMMPS_NS;

bool OutputTimes::begin_run(int every)
{
  const bool restored = restart_time_ >= 0.0;
  if (restored) offset_ = restart_time_ - lmp_->update->get_cur_time();
  restart_time_ = -1.0;
  const FixCheckpoint *checkpoint = find_checkpoint(lmp_);
  const bool goes_on = restored && checkpoint && checkpoint->continues();
  if (goes_on) last_step_ = lmp_->update->ntimestep;  // the run before wrote what was due
  if (!begun_) own_from_ = time() + (goes_on ? 0.5 * lmp_->update->dt : 0.0);
  begun_ = true;
  return (last_step_ < 0 && !restored) || lmp_->update->ntimestep % every == 0;
}

bool OutputTimes::take_step()
{
  if (lmp_->update->ntimestep == last_step_) return false;
  last_step_ = lmp_->update->ntimestep;
  return true;
}

double OutputTimes::time() const { return lmp_->update->get_cur_time() + offset_; }

void OutputTimes::write_restart(FILE *fp) const
{
  if (lmp_->comm->me != 0) return;
  const double state = time();
  const int size = sizeof state;
  fwrite(&size, sizeof(int), 1, fp);
  fwrite(&state, sizeof state, 1, fp);
}

void OutputTimes::restart(const char *buffer) { memcpy(&restart_time_, buffer, sizeof restart_time_); }
