#include "fix_swell.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "atom.h"
#include "comm.h"
#include "contact_forces.h"
#include "error.h"
#include "fix_fluid_scalar.h"
#include "fix_checkpoint.h"
#include "fix_objects.h"
#include "neighbor.h"
#include "object_geometry.h"
#include "options.h"
#include "update.h"

using namespace LAMMPS_NS;
using namespace FixConst;
using swellflow::ObjectPoints;

namespace {

/// Whether two points have the same natural size at all times.
bool starts_alike(const double *a, const double *b)
{
  using enum FixObjects::Column;
  for (const int column : {START_DIAMETER, START_TIME, RATE_FACTOR, SIZE_FACTOR, DIAMETER, OBJECT_MASS})
    if (a[column] != b[column]) return false;
  return true;
}

}  // namespace

/* ---------------------------------------------------------------------- */

FixSwell::FixSwell(LAMMPS *lmp, int narg, char **arg) :
    Fix(lmp, narg, arg), variable_value_(1.0), variable_before_(1.0), least_variable_(0.0), least_object_(0), restored_(false), own_settled_at_(-1), settled_at_(-1),
    objects_(nullptr), values_{}, values_step_(-1)
{
  swellflow::or_stop(lmp, [&] {
    swellflow::Arguments line(std::string("fix ") + id + " swell", narg - 3, arg + 3);
    script_ = swellflow::read_swell(lmp, line);
  });
  clock_ = {.base_time = 0.0, .base_step = static_cast<long>(update->ntimestep), .step_length = script_.clock * update->dt};
  restart_global = 1;
  scalar_flag = vector_flag = 1;
  size_vector = N_VALUES;
  global_freq = 1;
  extscalar = extvector = 0;
  nevery = 1;
}

int FixSwell::setmask()
{
  return POST_INTEGRATE | PRE_FORCE | (script_.has_own_clocks() ? PRE_INITIAL_INTEGRATE : 0) | (script_.slowed_by_load() || script_.clock > 1.0 ? END_OF_STEP : 0);
}

void FixSwell::post_create()
{
  objects_ = require_objects(lmp, *this);
  // A law that does not come from a restart file begins at the present sizes, whatever laws there were before.
  if (!restored_) forget_starts();
}

void FixSwell::pre_delete(bool unfixflag)
{
  objects_ = find_objects(lmp);
  if (unfixflag && objects_) forget_starts();
}

void FixSwell::init()
{
  objects_ = require_objects(lmp, *this);
  // Without this flag LIGGGHTS' neighbour lists ignore that radii grow.
  atom->radvary_flag = 1;
  clock_.change_step_length(update->ntimestep, script_.clock * update->dt);
  require_one_law_per_object();
  if (script_.slowed_by_load()) require_whole_forces(lmp, *this);
  if (script_.needs_food()) find_food();
  start_law();
  if (script_.law) {
    require_starts();
    require_sizes();
  } else {
    swellflow::or_stop(lmp, [this] { script_.size.require(lmp); });
    find_least_variable();
  }
  values_step_ = pace_step_ = -1;
}

/* ---------------------------------------------------------------------- */

bool FixSwell::is_ours(int i) const { return (atom->mask[i] & groupbit) && objects_->is_point(i); }

double FixSwell::time() const { return clock_.time(update->ntimestep); }

/* ----------------------------------------------------------------------
   the object's own time since its law began: load and hunger move START_TIME on
------------------------------------------------------------------------- */

double FixSwell::elapsed(const double *point, double time) const
{
  return point[FixObjects::RATE_FACTOR] * (time - point[FixObjects::START_TIME]);
}

void FixSwell::setup_pre_force(int)
{
  evaluate_variable();
  variable_before_ = variable_value_;  // how it came there is not known
  grow(0, atom->nlocal + atom->nghost, true);
  own_settled_at_ = settled_at_ = -1;
}

void FixSwell::setup(int)
{
  objects_->require_whole_objects(*this);
  if (!script_.slowed_by_load()) return;
  if (auto *file = find_checkpoint(lmp); file && file->continues()) file->restore_forces();  // fixes that make some stand above this one
  measure_speeds();
}

/* ----------------------------------------------------------------------
   own points before LIGGGHTS decides on new neighbour lists, so that it
   sees how far radii have grown; images when they are there
------------------------------------------------------------------------- */

void FixSwell::post_integrate()
{
  values_step_ = pace_step_ = -1;  // a variable may have asked for the values of this step before it came
  if (settled()) return;
  evaluate_variable();
  own_settled_at_ = grow(0, atom->nlocal, false) ? neighbor->lastcall : -1;
}

void FixSwell::pre_force(int)
{
  if (script_.has_own_clocks()) tell_ghosts_their_starts();
  if (settled()) return;
  const bool ghosts_settled = grow(atom->nlocal, atom->nlocal + atom->nghost, false);
  settled_at_ = ghosts_settled && own_settled_at_ == neighbor->lastcall ? neighbor->lastcall : -1;
}

/* ----------------------------------------------------------------------
   all points of this rank keep their size until there are new ones. A
   variable must be evaluated on all ranks, also on those without points.
------------------------------------------------------------------------- */

bool FixSwell::settled() const { return script_.law && settled_at_ >= 0 && settled_at_ == neighbor->lastcall; }

void FixSwell::evaluate_variable()
{
  if (script_.law) return;
  variable_before_ = variable_value_;
  swellflow::with_variables(lmp, update->ntimestep + 1, [this] { variable_value_ = script_.size.evaluate(lmp); });
  if (!(variable_value_ > least_variable_)) fail_size(least_object_, variable_value_, time());
}

FixSwell::Natural FixSwell::natural(const double *point, double time) const
{
  const double start = point[FixObjects::START_DIAMETER], t = elapsed(point, time), made = point[FixObjects::DIAMETER];
  const double diameter = script_.law ? script_.law->diameter(start, t) : script_.size_is_ratio ? variable_value_ * made : variable_value_;
  const double lambda = scattered(point, diameter) / made;
  return {.lambda = lambda, .mass = mass_ratio(point, lambda), .settled = script_.law && script_.law->settled(start, t)};
}

/* ----------------------------------------------------------------------
   mass over that at creation, per unit depth: constant density, or
   m = m0 + rho_w (A - A0) with the area A of the disc of the same area
------------------------------------------------------------------------- */

double FixSwell::water_ratio(const double *point) const
{
  const double made = point[FixObjects::DIAMETER];
  return script_.water_density * std::numbers::pi / 4.0 * made * made / point[FixObjects::OBJECT_MASS];
}

double FixSwell::mass_ratio(const double *point, double lambda) const
{
  const double area_ratio = lambda * lambda;
  return script_.drinks ? 1.0 + water_ratio(point) * (area_ratio - 1.0) : area_ratio;
}

/* ----------------------------------------------------------------------
   returns whether all these points keep their size from now on. `all`:
   also what follows from a size that has not changed.
------------------------------------------------------------------------- */

bool FixSwell::grow(int from, int to, bool all)
{
  if (from == to) return true;
  swellflow::StepClock::Scope timing(objects_->clock(), swellflow::StepClock::swelling);
  double **points = objects_->points(), **sizes = objects_->sizes();
  const double t = time();
  const double *like = nullptr;  // the point that `now` is of: neighbours in memory belong to one object, or to objects that began alike
  int molecule = 0;              // of its object
  Natural now{};
  bool all_settled = true;
  for (int i = from; i < to; i++) {
    double *size = sizes[i];
    if (!(atom->mask[i] & groupbit) || size[FixObjects::LAMBDA] == 0.0) continue;
    if (!like || atom->molecule[i] != molecule) {
      if (!like || !starts_alike(like, points[i])) now = natural(points[i], t);
      like = points[i];
      molecule = atom->molecule[i];
    }
    all_settled = all_settled && now.settled;
    if (!all && now.lambda == size[FixObjects::LAMBDA]) continue;
    size[FixObjects::LAMBDA] = now.lambda;
    atom->radius[i] = now.lambda * size[FixObjects::CDS_RADIUS];
    atom->rmass[i] = now.mass * size[FixObjects::MASS];
  }
  return all_settled;
}

/* ----------------------------------------------------------------------
   Under load an object's clock runs at the speed (1 - p/P)^N of its mean
   contact pressure p: the time that it loses over the next step is added
   to its START_TIME. Own points get it from the one rank that owns the hub.
------------------------------------------------------------------------- */

double FixSwell::speed(double pressure) const
{
  return std::pow(std::clamp(1.0 - pressure / script_.swelling_pressure, 0.0, 1.0), script_.load_exponent);
}

void FixSwell::end_of_step()
{
  if (script_.slowed_by_load()) measure_speeds();
  look_at_pace();
}

void FixSwell::measure_speeds()
{
  const ContactForces contacts(lmp);
  speeds_.assign(atom->nlocal + atom->nghost, 1.0);
  for (const ObjectPoints &object : objects_->objects())
    if ((atom->mask[object.hub] & groupbit) && objects_->owns(object)) speeds_[objects_->own_index(object.hub)] = speed(contacts.pressure(object));
  objects_->send_to_ghosts(speeds_.data(), 1);
}

/* ----------------------------------------------------------------------
   All points of an object have the same value of what it feeds on
------------------------------------------------------------------------- */

double FixSwell::speed_by_food(int own) const { return std::clamp(food_->concentration(own) / script_.full, 0.0, 1.0); }

/* ----------------------------------------------------------------------
   Atoms have not been renumbered since the speeds were measured. LIGGGHTS
   has counted the step already. What a clock that stands still loses is the
   difference of two times, exactly, so that its own time stays as it was.
------------------------------------------------------------------------- */

void FixSwell::pre_initial_integrate()
{
  const double step = time() - clock_.time(update->ntimestep - 1);
  for (const ObjectPoints &object : objects_->objects()) {
    if (!(atom->mask[object.hub] & groupbit)) continue;
    const double under_load = script_.slowed_by_load() ? speeds_[object.hub] : 1.0;
    for_each_point(object, [&](int i) {
      const int own = objects_->own_index(i);
      if (own < 0) return;
      const double speed = food_ ? under_load * speed_by_food(own) : under_load;
      if (speed < 1.0) objects_->points()[own][FixObjects::START_TIME] += (1.0 - speed) * step;
    });
  }
}

void FixSwell::tell_ghosts_their_starts()
{
  const int n_own = atom->nlocal, n = n_own + atom->nghost;
  double **points = objects_->points();
  sent_.resize(n);
  for (int i = 0; i < n_own; i++) sent_[i] = points[i][FixObjects::START_TIME];
  objects_->send_to_ghosts(sent_.data(), 1);
  for (int i = n_own; i < n; i++) points[i][FixObjects::START_TIME] = sent_[i];
}

/* ----------------------------------------------------------------------
   the clock goes on over changes of the step and over restarts
------------------------------------------------------------------------- */

void FixSwell::reset_dt() { clock_.change_step_length(update->ntimestep, script_.clock * update->dt); }

void FixSwell::reset_timestep(bigint new_step, bigint old_step) { clock_.renumber(new_step, old_step); }

void FixSwell::write_restart(FILE *fp)
{
  if (comm->me != 0) return;
  const double state[] = {clock_.base_time, static_cast<double>(clock_.base_step), clock_.step_length};
  const int size = sizeof state;
  fwrite(&size, sizeof(int), 1, fp);
  fwrite(state, sizeof(double), 3, fp);
}

void FixSwell::restart(char *buffer)
{
  const auto *state = reinterpret_cast<const double *>(buffer);
  clock_ = {.base_time = state[0], .base_step = static_cast<long>(state[1]), .step_length = state[2]};
  restored_ = true;
}
