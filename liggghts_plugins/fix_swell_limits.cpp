// What the guard and the accuracy budget ask of swelling.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "atom.h"
#include "domain.h"
#include "fix_fluid_ib.h"
#include "fix_mass_spring.h"
#include "fix_objects.h"
#include "fix_rigid_cds.h"
#include "fix_swell.h"
#include "force.h"
#include "modify.h"
#include "object_geometry.h"
#include "options.h"
#include "update.h"
#include "worst_object.h"

using namespace LAMMPS_NS;
using swellflow::Figure;
using swellflow::ObjectPoints;
using swellflow::SwellingPace;

/* ----------------------------------------------------------------------
   of the ratio, over `span` DEM steps, at moments that are spread over the
   run. A variable is known in its step only.
------------------------------------------------------------------------- */

double FixSwell::fastest_growth(const double *point, double span) const
{
  constexpr int moments = 20;
  const double begin = time(), end = clock_.time(update->laststep), step = span * clock_.step_length;
  double fastest = 0.0;
  for (int k = 0; k < moments; k++) {
    const double t = begin + (end - begin) * k / moments;
    fastest = std::max(fastest, std::abs(natural(point, std::min(t + step, std::max(end, t + clock_.step_length))).lambda - natural(point, t).lambda));
  }
  return fastest;
}

bool FixSwell::is_rigid(const ObjectPoints &object) const
{
  for (int k = 0; k < modify->nfix; k++)
    if (const Fix *fix = modify->fix[k]; dynamic_cast<const FixRigidCds *>(fix) && (atom->mask[object.hub] & fix->groupbit)) return true;
  return false;
}

/// Its radius; infinite when the object has none.
double FixSwell::smallest_sphere(const ObjectPoints &object) const
{
  double smallest = HUGE_VAL;
  for_each_point(object, [&](int i) {
    const double *size = objects_->sizes()[i];
    if (objects_->points()[i][FixObjects::HAS_CDS] > 0.0) smallest = std::min(smallest, size[FixObjects::LAMBDA] * size[FixObjects::CDS_RADIUS]);
  });
  return smallest;
}

/* ----------------------------------------------------------------------
   A size that springs follow with the frequency omega overshoots, when it
   sets out at once, by what it grows in 1 / omega.
------------------------------------------------------------------------- */

double FixSwell::growth_beyond_springs(const ObjectPoints &object) const
{
  double frequency = 0.0;
  for (int k = 0; k < modify->nfix; k++)
    if (const auto *springs = dynamic_cast<const FixMassSpring *>(modify->fix[k])) frequency = std::max(frequency, springs->breathing_frequency(object));
  const double *point = objects_->points()[object.hub];
  return frequency > 0.0 ? fastest_growth(point, 1.0 / (frequency * update->dt)) / objects_->sizes()[object.hub][FixObjects::LAMBDA] : 0.0;
}

/* ----------------------------------------------------------------------
   Of the circle about the hub that lies within the outline, whatever the
   shape and however it is turned.
------------------------------------------------------------------------- */

double FixSwell::inner_diameter_at_end(const ObjectPoints &object) const
{
  double radius = HUGE_VAL;
  for (const swellflow::Vector2 &corner : outline_of(lmp, object)) radius = std::min(radius, corner.norm());
  const double *point = objects_->points()[object.hub];
  return 2.0 * radius * natural(point, clock_.time(update->laststep)).lambda / objects_->sizes()[object.hub][FixObjects::LAMBDA];
}

void FixSwell::add_limits(std::vector<Figure> &figures)
{
  if (!script_.law) return;
  enum { CELLS, SPHERES, BOX, SPRINGS, RIGID, N_LIMITS };
  std::array<WorstObject, N_LIMITS> worst;
  const FixFluidIb *fluid = find_fluid(lmp);
  const double box = std::min(domain->xprd, domain->yprd), end = clock_.time(update->laststep);
  for (const ObjectPoints &object : objects_->objects()) {
    if (!objects_->owns(object) || !is_ours(object.hub)) continue;
    const double *point = objects_->points()[object.hub], growth = 0.5 * fastest_growth(point, 1.0) * point[FixObjects::DIAMETER];
    const bool rigid = is_rigid(object), ends_known = !script_.has_own_clocks();
    std::array<double, N_LIMITS> values{};
    if (fluid) values[CELLS] = growth * fluid->dem_steps_per_step() / fluid->cell();
    if (force->pair) values[SPHERES] = growth / smallest_sphere(object);
    if (ends_known) values[BOX] = natural(point, end).lambda * point[FixObjects::DIAMETER] / box;
    if (fluid && !rigid) values[SPRINGS] = growth_beyond_springs(object);
    if (rigid && ends_known) values[RIGID] = inner_diameter_at_end(object) / box;
    for (int k = 0; k < N_LIMITS; k++) worst[k].meet(values[k], atom->molecule[object.hub]);
  }
  agree_on_worst(world, worst);
  const auto add = [&](int k, const char *name, double watch, double poor, const char *remedy) {
    if (worst[k].object > 0)
      figures.push_back({.name = name, .value = worst[k].value, .watch = watch, .poor = poor,
                         .place = name_of(worst[k].object) + " and fix " + id, .remedy = remedy});
  };
  add(CELLS, "growth of an outline in a fluid step in cells", 0.5, Figure::never, "let it swell slower, lower 'clock', or use a shorter 'timestep'");
  add(SPHERES, "growth of an outline in a time step over the radius of its spheres", 0.1, 1.0, "let it swell slower, lower 'clock', or use a shorter 'timestep'");
  add(SPRINGS, "growth over the size, while springs pull an outline after it,", 0.05, 0.25, "let it swell slower, lower 'clock', or use stiffer springs or lighter objects");
  add(RIGID, "diameter of a rigid object at the end of the run over the width of the box", 1.0, 1.0, "lower the last size, make the box larger, or use springs");
  add(BOX, "natural diameter at the end of the run over the width of the box", 1.0, 2.0, "lower the last size, or make the box larger");
}

/* ----------------------------------------------------------------------
   A law that runs at its own speed is right at any speed
------------------------------------------------------------------------- */

void FixSwell::add_accuracy(std::vector<Figure> &figures)
{
  if (script_.clock <= 1.0) return;
  const SwellingPace pace = of_all_ranks(pace_of_run_);
  const std::string remedy = "lower 'clock' by that ratio";
  const auto add = [&](const char *name, double value) {
    if (value > 0.0) figures.push_back({.name = name, .value = value, .watch = 1.0, .poor = 10.0, .place = std::string("fix ") + id, .remedy = remedy});
  };
  add("speed of swelling / that which the flow can follow", pace.against_flow() / SwellingPace::flow_bound);
  add("speed of swelling / that which contacts can follow", pace.against_contacts() / SwellingPace::contact_bound);
}
