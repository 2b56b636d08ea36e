// How an object begins a law, and what is refused before the first step.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>

#include "atom.h"
#include "comm.h"
#include "error.h"
#include "fix_fluid_scalar.h"
#include "fix_objects.h"
#include "fix_swell.h"
#include "modify.h"
#include "objects/random_factor.h"
#include "options.h"
#include "update.h"
#include "worst_object.h"

using namespace LAMMPS_NS;
using swellflow::Purpose;
using swellflow::shown;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double worth_a_warning = 0.01;  // jump of the natural size, relative

}  // namespace

void FixSwell::require_one_law_per_object()
{
  for (int k = 0; k < modify->nfix; k++) {
    const Fix *other = modify->fix[k];
    if (other == this || strcmp(other->style, style) != 0) continue;
    int both = 0;
    for (int i = 0; i < atom->nlocal; i++) both |= is_ours(i) && (atom->mask[i] & other->groupbit);
    MPI_Allreduce(MPI_IN_PLACE, &both, 1, MPI_INT, MPI_MAX, world);
    if (both)
      error->fix_error(FLERR, this, (std::string("an object must swell by one law, but fix ") + other->id +
                                     " acts on the same objects: use groups that share none").c_str());
  }
}

void FixSwell::find_food()
{
  const int place = modify->find_fix(script_.food.c_str());
  food_ = place < 0 ? nullptr : dynamic_cast<FixFluidScalar *>(modify->fix[place]);
  if (!food_)
    error->fix_error(FLERR, this, ("'fed_by' must name a fix fluid/scalar, but '" + script_.food + "' " + (place < 0 ? "is no fix" : "is a fix of another style") +
                                   ": add one, or change the name").c_str());
}

void FixSwell::forget_starts()
{
  for (int i = 0; i < atom->nlocal; i++)
    if (is_ours(i)) objects_->points()[i][FixObjects::START_DIAMETER] = 0.0;
}

/* ----------------------------------------------------------------------
   objects that this law has not met yet begin it at their present size
------------------------------------------------------------------------- */

void FixSwell::start_law()
{
  WorstObject jump;
  for (int i = 0; i < atom->nlocal; i++) {
    double *point = objects_->points()[i];
    if (!is_ours(i) || point[FixObjects::START_DIAMETER] > 0.0) continue;
    const int object = atom->molecule[i];
    const double start = objects_->sizes()[i][FixObjects::LAMBDA] * point[FixObjects::DIAMETER];
    point[FixObjects::START_DIAMETER] = start;
    point[FixObjects::START_TIME] = time();
    point[FixObjects::RATE_FACTOR] = swellflow::lognormal_factor(Purpose::swelling_rate, script_.rate_scatter, script_.seed, object);
    point[FixObjects::SIZE_FACTOR] = swellflow::lognormal_factor(Purpose::swelling_size, script_.size_scatter, script_.seed, object);
    if (!script_.law) continue;
    jump.meet(std::abs(scattered(point, script_.law->diameter(start, 0.0)) / start - 1.0), object);
  }
  agree_on_worst(world, &jump, 1);
  if (jump.value > worth_a_warning && comm->me == 0)
    error->warning(FLERR, (std::string("fix ") + id + " swell: the law does not begin at the present size: the natural diameter of " + name_of(jump.object) +
                           " jumps by " + swellflow::rounded(100.0 * jump.value) + " %").c_str());
}

/* ----------------------------------------------------------------------
   growth over that of the law, and its inverse
------------------------------------------------------------------------- */

double FixSwell::scattered(const double *point, double law_diameter) const
{
  const double start = point[FixObjects::START_DIAMETER], factor = point[FixObjects::SIZE_FACTOR];
  return factor == 1.0 ? law_diameter : start + factor * (law_diameter - start);
}

double FixSwell::law_diameter_for(const double *point, double natural_diameter) const
{
  const double start = point[FixObjects::START_DIAMETER], factor = point[FixObjects::SIZE_FACTOR];
  return factor == 1.0 ? natural_diameter : start + (natural_diameter - start) / factor;
}

/* ----------------------------------------------------------------------
   the starts that the law can go on from
------------------------------------------------------------------------- */

void FixSwell::require_starts()
{
  double bounds[2] = {-infinity, -infinity};  // - smallest, largest
  for (int i = 0; i < atom->nlocal; i++) {
    if (!is_ours(i)) continue;
    const double start = objects_->points()[i][FixObjects::START_DIAMETER];
    bounds[0] = std::max(bounds[0], -start);
    bounds[1] = std::max(bounds[1], start);
  }
  MPI_Allreduce(MPI_IN_PLACE, bounds, 2, MPI_DOUBLE, MPI_MAX, world);
  const double smallest = -bounds[0], largest = bounds[1], least = script_.law->smallest_start(), most = script_.law->largest_start();
  if (largest > most * (1.0 + 1e-12))
    error->fix_error(FLERR, this, ("'max' must be at least the present natural diameter " + shown(largest) + ", but is " + shown(most) + ": raise it").c_str());
  if (smallest < least * (1.0 - 1e-12))
    error->fix_error(FLERR, this, ("'min' must be at most the present natural diameter " + shown(smallest) + ", but is " + shown(least) + ": lower it").c_str());
}

/* ----------------------------------------------------------------------
   The natural diameter down to which an object has a size and a mass
------------------------------------------------------------------------- */

double FixSwell::smallest_allowed(const double *point) const
{
  if (!script_.drinks) return 0.0;
  const double lightest = 1.0 - 1.0 / water_ratio(point);  // area ratio at which the mass is gone
  return lightest > 0.0 ? point[FixObjects::DIAMETER] * std::sqrt(lightest) : 0.0;
}

void FixSwell::fail_size(int object, double diameter, double time)
{
  const std::string rule = script_.drinks ? "the natural diameter must be > 0, and large enough for a mass > 0," : "the natural diameter must be > 0,";
  const std::string source = script_.law ? "the law gives " : "variable '" + script_.size.variable() + "' gives ";
  const std::string remedy = script_.law ? "change the law, let it end earlier, or make a shorter run" : "change its formula";
  const std::string value = (script_.size_is_ratio ? "ratio " : "diameter ") + (std::isfinite(diameter) ? swellflow::rounded(diameter) : "infinity");
  error->fix_error(FLERR, this, (rule + " but " + source + name_of(object) + " the " + value + " at time " + swellflow::rounded(time) +
                                 " of its clock: " + remedy).c_str());
}

/* ----------------------------------------------------------------------
   no size that the law gives until the end of the run is <= 0 or infinite.
   Before the run, because in a step ranks would have to ask each other.
------------------------------------------------------------------------- */

void FixSwell::require_sizes()
{
  const double end = clock_.time(update->laststep);
  struct { double time = infinity, diameter = infinity; } bad;
  WorstObject object{-infinity, 0};  // the first to fail
  for (int i = 0; i < atom->nlocal; i++) {
    const double *point = objects_->points()[i];
    if (!is_ours(i) || point[FixObjects::INDEX] >= 0.0) continue;
    const auto smallest = swellflow::smallest_size(*script_.law, point[FixObjects::START_DIAMETER], elapsed(point, time()), elapsed(point, end));
    if (smallest.diameter > law_diameter_for(point, smallest_allowed(point))) continue;
    const double when = point[FixObjects::START_TIME] + smallest.elapsed / point[FixObjects::RATE_FACTOR];
    if (-when < object.value || (-when == object.value && atom->molecule[i] > object.object)) continue;
    object = {-when, atom->molecule[i]};
    bad = {when, std::isfinite(smallest.diameter) ? scattered(point, smallest.diameter) : infinity};
  }
  const int own_object = object.object;
  agree_on_worst(world, &object, 1);
  if (object.object == 0) return;
  if (own_object != object.object) bad = {infinity, infinity};
  MPI_Allreduce(MPI_IN_PLACE, &bad, 2, MPI_DOUBLE, MPI_MIN, world);
  fail_size(object.object, bad.diameter, bad.time);
}

/* ----------------------------------------------------------------------
   a variable's value is known in its step only, but then on all ranks:
   with the least that is good for all objects none of them has to ask
------------------------------------------------------------------------- */

void FixSwell::find_least_variable()
{
  WorstObject least{-1.0, 0};
  for (int i = 0; i < atom->nlocal; i++) {
    if (!is_ours(i)) continue;
    const double *point = objects_->points()[i];
    const double unit = script_.size_is_ratio ? point[FixObjects::DIAMETER] : 1.0;
    least.meet(std::max(0.0, law_diameter_for(point, smallest_allowed(point)) / unit), atom->molecule[i]);
  }
  agree_on_worst(world, &least, 1);
  least_variable_ = std::max(0.0, least.value);
  least_object_ = least.object;
}
