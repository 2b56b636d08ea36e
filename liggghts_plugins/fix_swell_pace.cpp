// Whether swelling is slow beside the flow and beside contacts.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

#include "atom.h"
#include "comm.h"
#include "contact_forces.h"
#include "domain.h"
#include "error.h"
#include "fix_fluid_ib.h"
#include "fix_objects.h"
#include "fix_swell.h"
#include "object_geometry.h"
#include "objects/outline.h"
#include "options.h"
#include "update.h"

using namespace LAMMPS_NS;
using swellflow::ObjectPoints;
using swellflow::SwellingPace;

namespace {

constexpr int looks_a_run = 100;

}  // namespace

/* ----------------------------------------------------------------------
   of the natural diameter, per time of the simulation: over the coming
   step, or of a variable over the last one
------------------------------------------------------------------------- */

double FixSwell::growth_rate(const ObjectPoints &object) const
{
  const double *point = objects_->points()[object.hub], made = point[FixObjects::DIAMETER];
  if (!script_.law) return point[FixObjects::SIZE_FACTOR] * (variable_value_ - variable_before_) * (script_.size_is_ratio ? made : 1.0) / update->dt;
  const double step = time() - clock_.time(update->ntimestep - 1);
  const int own = objects_->own_index(object.hub);
  const double under_load = own < static_cast<int>(speeds_.size()) ? speeds_[own] : 1.0;
  return (food_ ? under_load * speed_by_food(own) : under_load) * made * (natural(point, time() + step).lambda - natural(point, time()).lambda) / update->dt;
}

/* ----------------------------------------------------------------------
   what this rank's objects do at this moment. Collective
------------------------------------------------------------------------- */

void FixSwell::add_pace(SwellingPace &pace) const
{
  swellflow::PaceOfFluid around;
  if (FixFluidIb *fluid = find_fluid(lmp)) {
    const double box = domain->xprd * domain->yprd;
    around = {.density = fluid->density(), .kinematic_viscosity = fluid->kinematic_viscosity(), .speed = std::sqrt(2.0 * fluid->compute_scalar() / (fluid->density() * box))};
  }
  const ContactForces contacts(lmp);
  for (const ObjectPoints &object : objects_->objects()) {
    if (!objects_->owns(object) || !(atom->mask[object.hub] & groupbit)) continue;
    const double *point = objects_->points()[object.hub], lambda = objects_->sizes()[object.hub][FixObjects::LAMBDA];
    const double area = lambda * lambda * point[FixObjects::NATURAL_AREA];
    pace.add({.closing_speed = std::abs(growth_rate(object)), .diameter = lambda * point[FixObjects::DIAMETER], .area = area,
              .density = mass_ratio(point, lambda) * point[FixObjects::OBJECT_MASS] / area, .pressure = contacts.pressure(object)},
             around);
  }
}

SwellingPace FixSwell::of_all_ranks(const SwellingPace &own) const
{
  std::array<double, 2> sums = own.sums();
  double flow = own.against_flow();
  MPI_Allreduce(MPI_IN_PLACE, sums.data(), 2, MPI_DOUBLE, MPI_SUM, world);
  MPI_Allreduce(MPI_IN_PLACE, &flow, 1, MPI_DOUBLE, MPI_MAX, world);
  return SwellingPace::of(sums, flow);
}

const SwellingPace &FixSwell::pace_now()
{
  if (pace_step_ == update->ntimestep) return pace_now_;
  SwellingPace own;
  if (objects_->current_everywhere()) add_pace(own);
  pace_now_ = of_all_ranks(own);
  pace_step_ = update->ntimestep;
  return pace_now_;
}

/* ----------------------------------------------------------------------
   A hundred looks a run tell whether its clock was too fast. A law that
   runs at its own speed is right at any speed.
------------------------------------------------------------------------- */

void FixSwell::look_at_pace()
{
  if (script_.clock <= 1.0 || warned_) return;
  const bigint interval = std::max<bigint>(1, (update->laststep - update->firststep) / looks_a_run);
  if ((update->ntimestep - update->firststep) % interval == 0) add_pace(pace_of_run_);
}

void FixSwell::post_run()
{
  if (script_.clock <= 1.0 || warned_) return;
  const SwellingPace pace = of_all_ranks(pace_of_run_);
  const auto warn = [this](const char *beside, const char *what, int n, double value, double bound) {
    if (value <= bound) return;
    warned_ = true;
    if (comm->me == 0)
      error->warning(FLERR, (std::string("fix ") + id + " swell: with 'clock " + swellflow::shown(script_.clock) + "' swelling was not slow beside " + beside + ": " + what + " (f_" + id + "[" +
                             std::to_string(n) + "]) was " + swellflow::rounded(value) + ", and should be below " + swellflow::shown(bound) + ": lower 'clock' by that ratio").c_str());
  };
  warn("the flow", "the largest growth over the speed at which the flow adapts", 10, pace.against_flow(), SwellingPace::flow_bound);
  warn("contacts", "the inertial number", 11, pace.against_contacts(), SwellingPace::contact_bound);
}
