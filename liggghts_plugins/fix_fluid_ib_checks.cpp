// What must hold before a fluid can run, and what users are told when it does not.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "fix_fluid_ib.h"
#include "fix_objects.h"
#include "fix_swell.h"
#include "fluid_columns.h"
#include "integrators.h"
#include "modify.h"
#include "options.h"
#include "update.h"

using namespace LAMMPS_NS;
using namespace swellflow;
using namespace std::string_literals;

double FixFluidIb::smallest_object() const
{
  const FixObjects *known = find_objects(lmp);
  double smallest = std::numeric_limits<double>::infinity();
  if (known)
    for (int i = 0; i < atom->nlocal; i++)
      if (known->is_point(i)) smallest = std::min(smallest, known->points()[i][FixObjects::DIAMETER]);
  MPI_Allreduce(MPI_IN_PLACE, &smallest, 1, MPI_DOUBLE, MPI_MIN, world);
  return std::isfinite(smallest) ? smallest : 0.0;
}

void FixFluidIb::require_settings()
{
  if (domain->dimension != 2)
    error->fix_error(FLERR, this, "the fluid is two-dimensional, but the dimension is 3: use 'dimension 2'");
  if (domain->triclinic || domain->box_change)
    error->fix_error(FLERR, this, "the fluid's box must be a fixed rectangle, but it is tilted or changes: use an orthogonal box and no fix deform");
  require_sides();
  if (!comm->ghost_velocity)
    error->fix_error(FLERR, this, "ranks must know the velocities of each other's points, but ghosts have none: add 'communicate single vel yes'");
  for (const char *name : swellflow::fluid_column_names)
    if (modify->find_fix(name) < 0)
      error->fix_error(FLERR, this, ("the fluid keeps its state in fix '" + std::string(name) + "', which is gone: do not unfix it").c_str());
}

void FixFluidIb::require_sides()
{
  for (int d = 0; d < 2; d++) {
    const std::string boundary = std::string("boundary ") + "xy"[d];
    for (int end = 0; end < 2; end++)
      if (domain->boundary[d][end] > 1)
        error->fix_error(FLERR, this, ("each side of the fluid must be at a fixed place or periodic, but " + boundary + " is '" +
                                       "pfsm"[domain->boundary[d][end]] + "': put f or p there in 'boundary'").c_str());
    const bool was_periodic = script_->options().sides[2 * d] == SideKind::periodic;
    if (was_periodic != (domain->periodicity[d] != 0))
      error->fix_error(FLERR, this, ("the sides of the fluid are those that its line was read with, but " + boundary +
                                     " was changed since: put 'change_box' above 'fix fluid/ib'").c_str());
    if (domain->boxlo[d] != box_low_[d] || domain->boxhi[d] != box_high_[d])
      error->fix_error(FLERR, this, ("the fluid fills the box that its line was read with, but in "s + "xy"[d] + " that went from " + shown(box_low_[d]) + " to " +
                                     shown(box_high_[d]) + " and now goes from " + shown(domain->boxlo[d]) + " to " + shown(domain->boxhi[d]) +
                                     ": put 'change_box' above 'fix fluid/ib'").c_str());
  }
}

/* ----------------------------------------------------------------------
   only integrators that know the fluid's law let the points feel it
------------------------------------------------------------------------- */

void FixFluidIb::require_integrators()
{
  const FixObjects *known = find_objects(lmp);
  if (!known) return;
  int moving = 0, moving_freely = 0;  // bits of the groups whose fixes move points
  for (int k = 0; k < modify->nfix; k++) {
    const Fix &fix = *modify->fix[k];
    if (!knows_fluid_law(fix)) continue;
    moving |= fix.groupbit;
    if (solves_springs(fix) || takes_springs_as_forces(fix)) moving_freely |= fix.groupbit;
  }
  int here[2] = {0, 0}, anywhere[2];  // some point is not moved; some is moved freely
  for (int i = 0; i < atom->nlocal; i++) {
    if (!known->is_point(i)) continue;
    here[0] |= !(atom->mask[i] & moving);
    here[1] |= (atom->mask[i] & moving_freely) != 0;
  }
  MPI_Allreduce(here, anywhere, 2, MPI_INT, MPI_MAX, world);
  if (anywhere[1] && script_->options().forcing == ForcingScheme::implicit)
    error->fix_error(FLERR, this, "implicit forcing needs objects that do not move freely, since these receive its force a step late and swing up, but some are moved by "
                                  "nve/cds or rigid/cds: use 'forcing multi 3', or 'held' or 'prescribed' for the objects");
  if (anywhere[0])
    error->fix_error(FLERR, this, "each object in the fluid needs an integrator that knows the fluid's force, but some have none: "
                                  "add 'fix ID all nve/cds' in place of other nve styles, or 'held' or 'prescribed' for objects that do not move freely");
}

/* ----------------------------------------------------------------------
   the fluid is incompressible: what objects push away leaves through an
   outflow, and what comes in there is what they, or an inflow, give
------------------------------------------------------------------------- */

const FixSwell *FixFluidIb::inflating_swell() const
{
  for (int k = 0; k < modify->nfix; k++)
    if (const auto *swell = dynamic_cast<FixSwell *>(modify->fix[k]); swell && !swell->absorbs()) return swell;
  return nullptr;
}

void FixFluidIb::require_way_out()
{
  const FixSwell *inflates = inflating_swell();
  const bool inflow = script_->has_inflow(), outflow = script_->has_outflow();
  const std::string place = "fix "s + id + " fluid/ib: ";
  or_stop(lmp, [&] {
    if (inflates && !outflow)
      throw OptionError(place + "objects that swell without drinking push the fluid away, which must be able to leave, but fix " + inflates->id +
                        " has 'absorb no' and the box has no 'outflow': add 'outflow SIDE', or let the objects drink with 'absorb yes'");
    if (outflow && !inflow && !inflates)
      throw OptionError(place + "through an outflow leaves what has come in or what swelling objects push away, but there is an 'outflow', no 'inflow' and no fix swell "
                        "with 'absorb no', so that nothing would leave: add 'inflow SIDE ...', or make it 'slip' or a wall");
  });
}

/* ----------------------------------------------------------------------
   the law of a fluid step under way was made for its time step
------------------------------------------------------------------------- */

void FixFluidIb::require_same_step()
{
  if (update->dt <= 0.0)
    error->fix_error(FLERR, this, ("the fluid needs a time step that is > 0, but it is " + shown(update->dt) + ": set one with 'timestep'").c_str());
  if (dem_step_ == 0 || update->dt == dt_) return;
  const bool chosen = script_->options().cfl > 0.0;
  const std::string remedy = chosen ? "with 'cfl', change it before the first run only" : "let the run before end with a multiple of 'every'";
  const std::string message = "the time step may change between fluid steps only, but it goes from " + shown(dt_) + " to " + shown(update->dt) + " after " +
                              std::to_string(dem_step_) + " of " + std::to_string(dem_steps_) + " DEM steps: " + remedy;
  error->fix_error(FLERR, this, message.c_str());
}

/* ---------------------------------------------------------------------- */

void FixFluidIb::warn_without_resistance()
{
  if (warned_ || !script_->is_driven_without_resistance()) return;
  const FixObjects *known = find_objects(lmp);
  int points = 0;
  for (int i = 0; known && i < atom->nlocal; i++) points += known->is_point(i);
  MPI_Allreduce(MPI_IN_PLACE, &points, 1, MPI_INT, MPI_SUM, world);
  warned_ = true;
  if (points == 0 && comm->me == 0)
    error->warning(FLERR, (std::string("Fix fluid/ib (id ") + id + "): a force drives the fluid along a periodic direction, and neither a wall nor an object "
                           "resists: the flow accelerates without bound. Use 'mean_velocity', a wall or an object").c_str());
}
