#include "fix_prescribed.h"

#include <cmath>
#include <cstring>
#include <numbers>
#include <string>

#include "atom.h"
#include "comm.h"
#include "error.h"
#include "fix_checkpoint.h"
#include "fix_fluid_ib.h"
#include "fix_objects.h"
#include "fix_swell.h"
#include "fluid_columns.h"
#include "integrators.h"
#include "modify.h"
#include "options.h"
#include "update.h"

using namespace LAMMPS_NS;
using namespace FixConst;
using swellflow::FluidHome;
using swellflow::FluidImpulse;
using swellflow::FluidLaw;
using swellflow::ObjectPoints;
using swellflow::ScriptValue;

FixPrescribed::FixPrescribed(LAMMPS *lmp, int narg, char **arg) : Fix(lmp, narg, arg)
{
  swellflow::or_stop(lmp, [&] {
    swellflow::Arguments line(std::string("fix ") + id + " " + style, narg - 3, arg + 3);
    swellflow::Options options(line.place());
    if (std::string(style) == "prescribed") {
      options.custom("velocity", [this](swellflow::Arguments &words) {
        vx_ = ScriptValue::read(words, "velocity, x", "length/time");
        vy_ = ScriptValue::read(words, "velocity, y", "length/time");
      }, "VX VY: of each object");
      options.custom("spin", [this](swellflow::Arguments &words) { spin_ = ScriptValue::read(words, "spin", "angle/time"); },
                     "W: of each object about its hub");
    }
    options.parse(line);
  });
  time_integrate = 1;
  restart_global = 1;
  vector_flag = 1;
  size_vector = N_VALUES;
  global_freq = 1;
  extvector = 0;
}

int FixPrescribed::setmask() { return INITIAL_INTEGRATE | FINAL_INTEGRATE; }

void FixPrescribed::post_create() { objects_ = require_objects(lmp, *this); }

void FixPrescribed::init()
{
  objects_ = require_objects(lmp, *this);
  require_one_integrator(lmp, *this);
  forget_what_is_ahead(lmp, *this);
  require_no_swelling();
  swellflow::or_stop(lmp, [this] {
    for (const ScriptValue *value : {&vx_, &vy_, &spin_}) value->require(lmp);
  });
}

void FixPrescribed::require_no_swelling()
{
  for (int k = 0; k < modify->nfix; k++) {
    const auto *swell = dynamic_cast<const FixSwell *>(modify->fix[k]);
    if (!swell || !share_atoms(lmp, *this, *swell)) continue;
    error->fix_error(FLERR, this, (std::string("an object that is moved as told keeps its size, but fix ") + swell->id +
                                   " (swell) acts on the same objects: use groups that share none").c_str());
  }
}

void FixPrescribed::setup(int)
{
  objects_->require_whole_objects(*this);
  motion_ = motion_now();
  const FixCheckpoint *checkpoint = find_checkpoint(lmp);
  if (!checkpoint || !checkpoint->continues()) advance(0.0, 0.0, 0.0);
}

/* ---------------------------------------------------------------------- */

FixPrescribed::Motion FixPrescribed::motion_now()
{
  Motion motion;
  const auto evaluate = [&] { motion = {vx_.evaluate(lmp), vy_.evaluate(lmp), spin_.evaluate(lmp)}; };
  if (vx_.is_variable() || vy_.is_variable() || spin_.is_variable())
    swellflow::with_variables(lmp, update->ntimestep + 1, evaluate);
  else
    evaluate();
  return motion;
}

/* ----------------------------------------------------------------------
   x and v at the end of the step, by the trapezoidal rule. LIGGGHTS has
   already counted this step, so that variables are as at its end.
------------------------------------------------------------------------- */

void FixPrescribed::initial_integrate(int)
{
  swellflow::StepClock::Scope timing(objects_->clock(), swellflow::StepClock::integration);
  values_known_ = false;
  const FixFluidIb *fluid = find_fluid(lmp);
  if (fluid && fluid->first_dem_step()) under_way_ = {.at_start = motion_, .at_end = motion_, .whole = true};
  receive_half_a_step();
  const Motion before = motion_;
  motion_ = motion_now();
  const double half_step = 0.5 * update->dt;
  advance(half_step * (before.vx + motion_.vx), half_step * (before.vy + motion_.vy), half_step * (before.spin + motion_.spin));
}

void FixPrescribed::final_integrate()
{
  swellflow::StepClock::Scope timing(objects_->clock(), swellflow::StepClock::integration);
  values_known_ = false;
  receive_half_a_step();
  under_way_.duration += update->dt;
  const FixFluidIb *fluid = find_fluid(lmp);
  if (!fluid || !fluid->last_dem_step() || !under_way_.whole) return;
  last_ = under_way_;
  last_.at_end = motion_;
}

/* ----------------------------------------------------------------------
   visit(own point, the image of it that is nearest to the hub); the hub
   comes last, so that the others still find it where it was
------------------------------------------------------------------------- */

template <class Visit> void FixPrescribed::for_each_own_point(const ObjectPoints &object, const Visit &visit) const
{
  for (int k = 0; k <= object.n_ring; k++) {
    const int image = k < object.n_ring ? object.ring[k] : object.hub;
    const int own = objects_->own_index(image);
    if (own >= 0) visit(own, image);
  }
}

/* ----------------------------------------------------------------------
   x' = x + d + (R - 1) r, v = V + W x r' with r from the hub to the point.
   What does not move keeps its last bit.
------------------------------------------------------------------------- */

void FixPrescribed::advance(double dx, double dy, double turn)
{
  double **x = atom->x, **v = atom->v;
  const double sine = std::sin(turn), half_sine = std::sin(0.5 * turn), cosine_less_1 = -2.0 * half_sine * half_sine;
  for (const ObjectPoints &object : objects_->objects()) {
    if (!(atom->mask[object.hub] & groupbit)) continue;
    const double hub_x = x[object.hub][0], hub_y = x[object.hub][1];
    for_each_own_point(object, [&](int own, int image) {
      const double rx = x[image][0] - hub_x, ry = x[image][1] - hub_y;
      const double turn_x = cosine_less_1 * rx - sine * ry, turn_y = sine * rx + cosine_less_1 * ry;
      x[own][0] += dx + turn_x;
      x[own][1] += dy + turn_y;
      v[own][0] = motion_.vx - motion_.spin * (ry + turn_y);
      v[own][1] = motion_.vy + motion_.spin * (rx + turn_x);
      v[own][2] = 0.0;
    });
  }
}

/* ----------------------------------------------------------------------
   the fluid's law, force = a - kappa v, over half a step with the velocity
   that the point has: over the whole step the trapezoidal rule
------------------------------------------------------------------------- */

void FixPrescribed::receive_half_a_step()
{
  double **law = fluid_columns(lmp, FluidLaw::NAME), **impulse = fluid_columns(lmp, FluidImpulse::NAME), **home = fluid_columns(lmp, FluidHome::NAME);
  if (!law || !impulse || !home) return;
  for (const ObjectPoints &object : objects_->objects()) {
    if (!(atom->mask[object.hub] & groupbit)) continue;
    for_each_own_point(object, [&](int own, int image) {
      const double arm[2] = {atom->x[image][0] - atom->x[object.hub][0], atom->x[image][1] - atom->x[object.hub][1]};
      receive(own, arm, law[own], home[own] + FluidHome::INNER_FORCE_X, impulse[own]);
    });
  }
}

void FixPrescribed::receive(int i, const double *arm, const double *law, const double *inner_force, double *impulse)
{
  double received[2];
  for (int d = 0; d < 2; d++) {
    const double force = law[FluidLaw::A_X + d] - law[FluidLaw::KAPPA] * atom->v[i][d];
    impulse[d] += 0.5 * update->dt * force;
    received[d] = 0.5 * update->dt * (force - inner_force[d]);
  }
  under_way_.impulse[0] += received[0];
  under_way_.impulse[1] += received[1];
  under_way_.angular_impulse += arm[0] * received[1] - arm[1] * received[0];
}

/* ----------------------------------------------------------------------
   what the fluid around does: the impulse on the points also moves the
   fluid inside, rho_f V a and rho_f I alpha, I = V times the mean of r^2
   (rigid bodies with fluid inside: Uhlmann, J. Comput. Phys. 209, 2005)
------------------------------------------------------------------------- */

const FixPrescribed::Values &FixPrescribed::values()
{
  if (values_known_) return values_;
  values_ = {0.0, 0.0, 0.0, motion_.vx, motion_.vy, motion_.spin};
  const FixFluidIb *fluid = find_fluid(lmp);
  if (!fluid || (fluid->whole_steps() == 0 && !restored_) || last_.duration == 0.0) return values_;
  values_known_ = true;

  double sums[5] = {last_.impulse[0], last_.impulse[1], last_.angular_impulse, 0.0, 0.0};
  if (objects_->current_everywhere())
    for (const ObjectPoints &object : objects_->objects()) {
      if (!objects_->owns(object) || !(atom->mask[object.hub] & groupbit)) continue;
      const double *point = objects_->points()[object.hub];
      const double lambda = objects_->sizes()[object.hub][FixObjects::LAMBDA], D = lambda * point[FixObjects::DIAMETER], V = 0.25 * std::numbers::pi * D * D;
      sums[3] += V;
      sums[4] += V * lambda * lambda * point[FixObjects::MEAN_SQUARE_RADIUS];
    }
  MPI_Allreduce(MPI_IN_PLACE, sums, 5, MPI_DOUBLE, MPI_SUM, world);
  const double rho_f = fluid->density(), V = sums[3], I = sums[4];
  const Motion &from = last_.at_start, &to = last_.at_end;
  values_[DRAG] = (sums[0] + rho_f * V * (to.vx - from.vx)) / last_.duration;
  values_[LIFT] = (sums[1] + rho_f * V * (to.vy - from.vy)) / last_.duration;
  values_[TORQUE] = (sums[2] + rho_f * I * (to.spin - from.spin)) / last_.duration;
  return values_;
}

double FixPrescribed::compute_vector(int n) { return values()[n]; }

/* ----------------------------------------------------------------------
   what the last fluid step did, so that a run that goes on shows it
------------------------------------------------------------------------- */

void FixPrescribed::write_restart(FILE *fp)
{
  Account sum = last_;
  double parts[3] = {last_.impulse[0], last_.impulse[1], last_.angular_impulse}, sums[3];
  MPI_Allreduce(parts, sums, 3, MPI_DOUBLE, MPI_SUM, world);
  if (comm->me != 0) return;
  std::copy_n(sums, 2, sum.impulse);
  sum.angular_impulse = sums[2];
  const int size = sizeof sum;
  fwrite(&size, sizeof size, 1, fp);
  fwrite(&sum, sizeof sum, 1, fp);
}

void FixPrescribed::restart(char *buffer)
{
  memcpy(&last_, buffer, sizeof last_);
  restored_ = true;
  if (comm->me == 0) return;
  last_.impulse[0] = last_.impulse[1] = last_.angular_impulse = 0.0;
}
