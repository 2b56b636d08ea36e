#include "fix_swell.h"

#include <algorithm>
#include <cmath>

#include "atom.h"
#include "comm.h"
#include "error.h"
#include "fix_objects.h"
#include "modify.h"
#include "objects/outline.h"
#include "options.h"
#include "update.h"

using namespace LAMMPS_NS;
using namespace FixConst;
using swellflow::ObjectPoints;
using swellflow::Range;
using swellflow::Vector2;

/* ---------------------------------------------------------------------- */

FixSwell::FixSwell(LAMMPS *lmp, int narg, char **arg) :
    Fix(lmp, narg, arg), law_(LINEAR), absorb_(true), variable_value_(1.0), objects_(nullptr), values_{}, values_step_(-1)
{
  swellflow::or_stop(lmp, [&] { parse(narg, arg); });
  clock_ = {.base_time = 0.0, .base_step = static_cast<long>(update->ntimestep), .step_length = update->dt};
  restart_global = 1;
  scalar_flag = vector_flag = 1;
  size_vector = N_VALUES;
  global_freq = 1;
  extscalar = extvector = 0;
}

void FixSwell::parse(int narg, char **arg)
{
  swellflow::Arguments line(std::string("fix ") + id + " swell", narg - 3, arg + 3);
  law_ = static_cast<Law>(line.choice("law", {"linear", "diameter", "ratio"}));
  swellflow::Options options(line.place());
  options.yes_no("absorb", absorb_, "whether the objects drink the fluid that they grow by");
  if (law_ == LINEAR) {
    options.number("rate", linear_.rate, Range::not_negative(), "diameter per time", "growth of the natural diameter").required();
    options.number("max", linear_.largest_diameter, Range::positive(), "length", "largest natural diameter").required();
  } else {
    const std::string given = line.empty() ? "" : line.peek();
    if (given.rfind("v_", 0) != 0) line.fail("the size must be an equal-style variable written v_NAME, but is '" + given + "': change it");
    size_ = swellflow::ScriptValue::read(line, law_ == DIAMETER ? "diameter" : "ratio", law_ == DIAMETER ? "length" : "swelling ratio");
  }
  options.parse(line);
}

int FixSwell::setmask() { return POST_INTEGRATE | PRE_FORCE; }

void FixSwell::post_create() { objects_ = require_objects(lmp, *this); }

void FixSwell::pre_delete(bool unfixflag)
{
  // A later law begins at the size that this one leaves.
  FixObjects *objects = find_objects(lmp);
  if (!unfixflag || !objects) return;
  for (int i = 0; i < atom->nlocal; i++)
    if ((atom->mask[i] & groupbit) && objects->is_point(i)) objects->points()[i][FixObjects::START_DIAMETER] = 0.0;
}

void FixSwell::init()
{
  objects_ = require_objects(lmp, *this);
  // Without this flag LIGGGHTS' neighbour lists ignore that radii grow.
  atom->radvary_flag = 1;
  clock_.change_step_length(update->ntimestep, update->dt);
  require_one_law_per_object();
  start_law();
  check_law();
  values_step_ = -1;
}

void FixSwell::require_one_law_per_object()
{
  for (int k = 0; k < modify->nfix; k++) {
    const Fix *other = modify->fix[k];
    if (other == this || strcmp(other->style, style) != 0) continue;
    int both = 0;
    for (int i = 0; i < atom->nlocal; i++)
      both |= objects_->is_point(i) && (atom->mask[i] & groupbit) && (atom->mask[i] & other->groupbit);
    MPI_Allreduce(MPI_IN_PLACE, &both, 1, MPI_INT, MPI_MAX, world);
    if (both)
      error->fix_error(FLERR, this, (std::string("an object must swell by one law, but fix ") + other->id +
                                     " acts on the same objects: use groups that share none").c_str());
  }
}

/* ----------------------------------------------------------------------
   objects that this law has not met yet begin it at their present size
------------------------------------------------------------------------- */

void FixSwell::start_law()
{
  double **points = objects_->points();
  for (int i = 0; i < atom->nlocal; i++) {
    if (!(atom->mask[i] & groupbit) || !objects_->is_point(i) || points[i][FixObjects::START_DIAMETER] > 0.0) continue;
    points[i][FixObjects::START_DIAMETER] = points[i][FixObjects::LAMBDA] * points[i][FixObjects::DIAMETER];
    points[i][FixObjects::START_TIME] = time();
  }
}

void FixSwell::check_law()
{
  if (law_ != LINEAR) {
    swellflow::or_stop(lmp, [this] { size_.require(lmp); });
    return;
  }
  double largest = 0.0;
  for (int i = 0; i < atom->nlocal; i++)
    if ((atom->mask[i] & groupbit) && objects_->is_point(i))
      largest = std::max(largest, objects_->points()[i][FixObjects::START_DIAMETER]);
  MPI_Allreduce(MPI_IN_PLACE, &largest, 1, MPI_DOUBLE, MPI_MAX, world);
  if (largest > linear_.largest_diameter * (1.0 + 1e-12))
    error->fix_error(FLERR, this, ("'max' must be at least the present natural diameter " + swellflow::shown(largest) + ", but is " +
                                   swellflow::shown(linear_.largest_diameter) + ": raise it").c_str());
}

/* ---------------------------------------------------------------------- */

double FixSwell::time() const { return clock_.time(update->ntimestep); }

void FixSwell::setup_pre_force(int)
{
  evaluate_variable();
  grow(0, atom->nlocal + atom->nghost);
}

void FixSwell::setup(int) { objects_->require_whole_objects(*this); }

/* ----------------------------------------------------------------------
   own points before LIGGGHTS decides on new neighbour lists, so that it
   sees how far radii have grown; images when they are there
------------------------------------------------------------------------- */

void FixSwell::post_integrate()
{
  values_step_ = -1;  // a variable may have asked for the values of this step before it came
  evaluate_variable();
  grow(0, atom->nlocal);
}

void FixSwell::pre_force(int) { grow(atom->nlocal, atom->nlocal + atom->nghost); }

void FixSwell::evaluate_variable()
{
  if (law_ == LINEAR) return;
  swellflow::with_variables(lmp, update->ntimestep + 1, [this] { variable_value_ = size_.evaluate(lmp); });
  if (!Range::positive().holds(variable_value_))
    error->fix_error(FLERR, this, ("the size must be a number > 0, but variable '" + size_.variable() + "' gave " +
                                   swellflow::shown(variable_value_) + ": change its formula").c_str());
}

double FixSwell::natural_lambda(const double *point, double time) const
{
  if (law_ == RATIO) return variable_value_;
  if (law_ == DIAMETER) return variable_value_ / point[FixObjects::DIAMETER];
  return linear_.diameter(point[FixObjects::START_DIAMETER], time - point[FixObjects::START_TIME]) / point[FixObjects::DIAMETER];
}

void FixSwell::grow(int from, int to)
{
  swellflow::StepClock::Scope timing(objects_->clock(), swellflow::StepClock::swelling);
  double **points = objects_->points();
  const double t = time();
  for (int i = from; i < to; i++) {
    if (!(atom->mask[i] & groupbit) || !objects_->is_point(i)) continue;
    const double lambda = natural_lambda(points[i], t);
    points[i][FixObjects::LAMBDA] = lambda;
    atom->radius[i] = lambda * points[i][FixObjects::CDS_RADIUS];
    atom->rmass[i] = lambda * lambda * points[i][FixObjects::MASS];  // per unit depth, at constant density
  }
}

/* ----------------------------------------------------------------------
   the clock goes on over changes of the step and over restarts
------------------------------------------------------------------------- */

void FixSwell::reset_dt() { clock_.change_step_length(update->ntimestep, update->dt); }

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
}

/* ----------------------------------------------------------------------
   values for thermo
------------------------------------------------------------------------- */

void FixSwell::add_object(const ObjectPoints &object, double *sums, double *extremes) const
{
  const double *hub = atom->x[object.hub], *point = objects_->points()[object.hub];
  std::vector<Vector2> ring;
  double distance = 0.0;
  for (int k = 0; k < object.n_ring; k++) {
    const double *x = atom->x[object.ring[k]];
    ring.emplace_back(x[0] - hub[0], x[1] - hub[1]);
    distance += ring.back().norm();
  }
  const double natural = point[FixObjects::LAMBDA] * point[FixObjects::DIAMETER];
  const swellflow::OutlineShape shape = swellflow::outline_shape(ring);
  const double natural_area = point[FixObjects::NATURAL_AREA] * point[FixObjects::LAMBDA] * point[FixObjects::LAMBDA];
  const double area_ratio = shape.area / natural_area;
  sums[COUNT] += 1.0;
  sums[NATURAL] += natural;
  sums[HUB_DISTANCE] += 2.0 * distance / object.n_ring;
  sums[OF_AREA] += swellflow::diameter_of_area(shape.area, point[FixObjects::NATURAL_AREA], point[FixObjects::DIAMETER]);
  sums[ASPECT_RATIO] += shape.aspect_ratio;
  sums[AREA] += shape.area;
  extremes[MINUS_AREA_RATIO] = std::max(extremes[MINUS_AREA_RATIO], -area_ratio);
  extremes[LAMBDA_MAX] = std::max(extremes[LAMBDA_MAX], point[FixObjects::LAMBDA]);
}

const double *FixSwell::values()
{
  if (values_step_ == update->ntimestep) return values_;
  double sums[N_SUMS] = {}, extremes[N_EXTREMES] = {-1e300, 0.0};
  const bool current = objects_->current();
  for (std::size_t k = 0; current && k < objects_->objects().size(); k++) {
    const ObjectPoints &object = objects_->objects()[k];
    if (objects_->owns(object) && (atom->mask[object.hub] & groupbit)) add_object(object, sums, extremes);
  }
  MPI_Allreduce(MPI_IN_PLACE, sums, N_SUMS, MPI_DOUBLE, MPI_SUM, world);
  MPI_Allreduce(MPI_IN_PLACE, extremes, N_EXTREMES, MPI_DOUBLE, MPI_MAX, world);
  const double n = std::max(sums[COUNT], 1.0), area_ratio = sums[COUNT] > 0.0 ? -extremes[MINUS_AREA_RATIO] : 0.0;
  const double all[N_VALUES] = {sums[NATURAL] / n, sums[HUB_DISTANCE] / n, sums[OF_AREA] / n, sums[ASPECT_RATIO] / n,
                                area_ratio,        sums[AREA],             extremes[LAMBDA_MAX], time()};
  std::copy(all, all + N_VALUES, values_);
  values_step_ = update->ntimestep;
  return values_;
}

double FixSwell::compute_scalar() { return values()[0]; }

double FixSwell::compute_vector(int n) { return values()[n]; }
