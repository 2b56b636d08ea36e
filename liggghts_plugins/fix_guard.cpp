#include "fix_guard.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <stdexcept>

#include "comm.h"
#include "error.h"
#include "fix_checkpoint.h"
#include "fix_fluid_ib.h"
#include "fix_objects.h"
#include "modify.h"
#include "options.h"
#include "output.h"
#include "update.h"

using namespace LAMMPS_NS;
using swellflow::Figure;
using swellflow::GuardMode;
using swellflow::rounded;

namespace {

constexpr int steps_between_looks = 20;           // without a fluid; with one there is a look each fluid step
constexpr int looks_between_areas = 20;
constexpr double smallest_area = 0.1;             // of an object in a fluid, of its natural one or that as it was made
constexpr double farthest_way = 2.0;              // of a point between two looks at what is around it, in radii of its object
constexpr const char *warning_only = ", or give 'guard warn' above the run to try it nevertheless";

/// Before the first step there is none to go on from, and nothing to go on with.
std::string last_good_file(LAMMPS *lmp)
{
  const FixCheckpoint *checkpoint = find_checkpoint(lmp);
  if (checkpoint && !checkpoint->to_go_on_from().empty()) return "; the last good restart file is '" + checkpoint->to_go_on_from() + "'";
  return lmp->update->ntimestep == lmp->update->firststep ? "" : "; no restart file has been written";
}

/// Fixes that write what they find: their frames and lines must not be of a scene that is broken.
bool writes(const Fix &fix)
{
  const char *kinds[] = {"output/", "ave/", "print"};
  return std::any_of(std::begin(kinds), std::end(kinds), [&](const char *kind) { return strncmp(fix.style, kind, strlen(kind)) == 0; });
}

}  // namespace

FixGuard::FixGuard(LAMMPS *lmp, int narg, char **arg) : Fix(lmp, narg, arg), state_(lmp), areas_(lmp), crossing_(lmp)
{
  if (strcmp(id, ID) != 0) error->fix_error(FLERR, this, "this fix is made with the box, under the id 'guard': remove it from the script, and use the command 'guard'");
  nevery = 1;
}

int FixGuard::setmask() { return FixConst::PRE_INITIAL_INTEGRATE | FixConst::END_OF_STEP; }

/* ----------------------------------------------------------------------
   limits, before the first step and when the time step is another one in
   a run with 'pre no'
------------------------------------------------------------------------- */

void FixGuard::setup(int)
{
  state_.begin();
  areas_.begin();
  looks_ = 0;
  looked_at_ = -1;
  find_writers();
  follow_areas();
  check_limits();
}

/// Once a run, since their names are compared.
void FixGuard::find_writers()
{
  written_every_.clear();
  for (int k = 0; k < modify->nfix; k++)
    if (const Fix &fix = *modify->fix[k]; writes(fix) && fix.nevery > 0) written_every_.push_back(fix.nevery);
}

void FixGuard::pre_initial_integrate()
{
  if (update->dt != step_of_limits_) check_limits();
}

void FixGuard::check_limits()
{
  step_of_limits_ = update->dt;
  if (mode_ != GuardMode::off) judge(swellflow::limits_of(lmp));
}

void FixGuard::judge(const std::vector<Figure> &limits)
{
  if (mode_ == GuardMode::off) return;
  const Figure *worst = nullptr;
  const auto excess = [](const Figure &figure) { return std::isfinite(figure.value) ? figure.value / figure.poor : HUGE_VAL; };
  for (const Figure &figure : limits)
    if (figure.is_poor() && (!worst || excess(figure) > excess(*worst))) worst = &figure;
  for (const Figure &figure : limits)
    if (!figure.is_fine() && (&figure != worst || mode_ == GuardMode::warn)) warn_once(figure, figure.is_poor() ? figure.poor : figure.watch);
  if (!worst || mode_ == GuardMode::warn) return;
  error->all(FLERR, ("guard: the " + worst->name + " must be at most " + rounded(worst->poor) + ", but is " + rounded(worst->value) + " for " + worst->place + " at step " +
                     std::to_string(update->ntimestep) + ": " + worst->remedy + warning_only + last_good_file(lmp)).c_str());
}

void FixGuard::warn_once(const Figure &figure, double bound)
{
  if (std::find(warned_.begin(), warned_.end(), figure.name) != warned_.end()) return;
  warned_.push_back(figure.name);
  if (comm->me == 0)
    error->warning(FLERR, ("guard: the " + figure.name + " should be at most " + rounded(bound) + ", but is " + rounded(figure.value) + " for " + figure.place + " at step " +
                           std::to_string(update->ntimestep) + ": " + figure.remedy).c_str());
}

/* ----------------------------------------------------------------------
   This is the first fix of a scene but for the checkpoint, so that what it
   finds at the end of a step is known before anything is written. The same
   on all ranks.
------------------------------------------------------------------------- */

bool FixGuard::is_due() const
{
  if (output->next == update->ntimestep) return true;
  const FixFluidIb *fluid = find_fluid(lmp);
  if (fluid ? fluid->last_dem_step() : update->ntimestep % steps_between_looks == 0) return true;
  return std::any_of(written_every_.begin(), written_every_.end(), [&](int every) { return update->ntimestep % every == 0; });
}

void FixGuard::end_of_step()
{
  if (!is_due()) return;
  if (++looks_ % looks_between_areas == 0) {
    follow_areas();
    look_for_crossings();
  }
  look();
}

void FixGuard::post_run()
{
  if (looked_at_ != update->ntimestep) look();
}

void FixGuard::look()
{
  looked_at_ = update->ntimestep;
  const FixFluidIb *fluid = find_fluid(lmp);
  const StateLook::Findings found = state_.look(update->dt * (fluid ? fluid->dem_steps_per_step() : 1));
  const auto &bad = found[StateLook::NOT_FINITE], &inverted = found[StateLook::INVERTED], &crushed = found[StateLook::CRUSHED], &runaway = found[StateLook::RUNAWAY];
  if (bad.value > 0.0)
    end_run(lmp, *this, "positions, velocities and forces must be finite, but " + (bad.object > 0 ? name_of(bad.object) : "an atom that is no object's") +
                          " has one that is infinite or not a number at step " + std::to_string(update->ntimestep) + ": use a shorter time step or softer springs and contacts");
  if (inverted.value >= 0.0)
    object_fails("an outline must not turn inside out, but " + name_of(inverted.object) + " has " + rounded(-inverted.value) + " of its natural area at step " +
                 std::to_string(update->ntimestep) + ": use stiffer springs or spokes, a shorter time step, or less that presses it");
  else if (fluid && crushed.value > -smallest_area)
    object_fails("the fluid inside an outline must stay there, but " + name_of(crushed.object) + " is crushed to " + rounded(-crushed.value) + " of its area at step " +
                 std::to_string(update->ntimestep) + ": use stiffer springs, more 'points', or less that presses it");
  if (runaway.value > farthest_way)
    object_fails("a point must stay near enough for others to meet it, but one of " + name_of(runaway.object) + " moves by " + rounded(runaway.value) + " radii of it in a " +
                 (fluid ? "fluid" : "time") + " step at step " + std::to_string(update->ntimestep) + ": use a shorter time step, or softer springs and contacts");
}

void FixGuard::look_for_crossings()
{
  if (const WorstObject found = crossing_.look(); found.object > 0)
    object_fails("objects must not pass into each other, but the middle of another lies within " + name_of(found.object) + " at step " + std::to_string(update->ntimestep) +
                 ": use stiffer contacts, a shorter time step, or more 'points'");
}

void FixGuard::object_fails(const std::string &message)
{
  if (mode_ == GuardMode::refuse) end_run(lmp, *this, message + warning_only);
  if (mode_ == GuardMode::warn && !warned_of_objects_ && comm->me == 0) error->warning(FLERR, ("guard: " + message).c_str());
  warned_of_objects_ = true;
}

/* ----------------------------------------------------------------------
   for the accuracy budget: what is inside outlines in a fluid
------------------------------------------------------------------------- */

void FixGuard::follow_areas()
{
  if (find_fluid(lmp)) areas_.look();
}

void FixGuard::add_accuracy(std::vector<Figure> &figures)
{
  follow_areas();
  if (!find_fluid(lmp) || !areas_.knows()) return;
  figures.push_back({.name = "area lost or won inside outlines", .value = areas_.error(), .watch = 0.01, .poor = 0.1, .place = "all objects together",
                     .remedy = "use more 'cells', a smaller 'marker_gap', or 'kernel gruninger_2025'"});
}

/* ---------------------------------------------------------------------- */

FixGuard *LAMMPS_NS::find_guard(LAMMPS *lmp)
{
  const int found = lmp->modify ? lmp->modify->find_fix(FixGuard::ID) : -1;
  return found < 0 ? nullptr : dynamic_cast<FixGuard *>(lmp->modify->fix[found]);
}

void LAMMPS_NS::judge(LAMMPS *lmp, const Figure &limit)
{
  if (FixGuard *guard = find_guard(lmp)) guard->judge({limit});
}

void LAMMPS_NS::end_run(LAMMPS *lmp, const Fix &fix, const std::string &what_happened)
{
  lmp->error->fix_error(FLERR, const_cast<Fix *>(&fix), (what_happened + last_good_file(lmp)).c_str());
  throw std::logic_error("unreachable");
}
