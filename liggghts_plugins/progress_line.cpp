#include "progress_line.h"

#include <cstdio>

#include "comm.h"
#include "fix_fluid_ib.h"
#include "timer.h"
#include "update.h"

using namespace LAMMPS_NS;
using swellflow::StepClock;

namespace {

constexpr double seconds_between_lines = 10.0;
constexpr double seconds_worth_a_line = 0.1;  // loops of very short runs stay quiet

}  // namespace

ProgressLine::Spent ProgressLine::spent(const StepClock &clock) const
{
  Spent now;
  now.wall = StepClock::now();
  const FixFluidIb *fix = find_fluid(lmp);
  if (const swellflow::FluidPartner *fluid = fix ? fix->partner() : nullptr) {
    now.fluid = fluid->seconds_in_fluid();
    now.coupling = fluid->seconds_in_coupling();
  }
  now.springs = clock.seconds(StepClock::springs);
  now.contacts = timer->array[TIME_PAIR] + timer->array[TIME_NEIGHBOR];
  return now;
}

void ProgressLine::start(const StepClock &clock)
{
  at_start_ = spent(clock);
  at_start_.contacts = 0.0;  // LIGGGHTS' timer starts at zero with each run
  last_print_ = at_start_.wall;
  first_step_ = update->ntimestep;
}

void ProgressLine::step(const StepClock &clock)
{
  if (comm->me != 0 || StepClock::now() - last_print_ < seconds_between_lines) return;
  last_print_ = StepClock::now();
  print(spent(clock));
}

void ProgressLine::finish(const StepClock &clock)
{
  if (comm->me != 0 || StepClock::now() - at_start_.wall < seconds_worth_a_line) return;
  print(spent(clock));
}

void ProgressLine::print(const Spent &now)
{
  if (!screen) return;
  const double wall = now.wall - at_start_.wall;
  const double steps = update->ntimestep - first_step_, all_steps = update->laststep - first_step_;
  const double done = all_steps > 0 ? steps / all_steps : 1.0;
  const double left = done > 0.0 ? wall * (1.0 - done) / done : 0.0;
  const double fluid = now.fluid - at_start_.fluid, coupling = now.coupling - at_start_.coupling;
  const double springs = now.springs - at_start_.springs, contacts = now.contacts - at_start_.contacts;
  const auto percent = [wall](double part) { return 100.0 * part / wall; };
  fprintf(screen, "Progress: %5.1f %% done, %.0f s left; fluid %.0f %%, coupling %.0f %%, springs %.0f %%, contacts %.0f %%, other %.0f %%\n",
          100.0 * done, left, percent(fluid), percent(coupling), percent(springs), percent(contacts),
          percent(wall - fluid - coupling - springs - contacts));
  fflush(screen);
}
