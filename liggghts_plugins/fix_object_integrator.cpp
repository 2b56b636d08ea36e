#include "fix_object_integrator.h"

#include "atom.h"
#include "comm.h"
#include "error.h"
#include "fix_objects.h"
#include "fluid_columns.h"
#include "force.h"
#include "integrators.h"
#include "objects/rigid_motion.h"
#include "options.h"
#include "update.h"

using namespace LAMMPS_NS;
using namespace FixConst;
using swellflow::FluidAhead;
using swellflow::FluidImpulse;
using swellflow::FluidLaw;
using swellflow::ObjectPoints;
using swellflow::Vector2;

FixObjectIntegrator::FixObjectIntegrator(LAMMPS *lmp, int narg, char **arg) :
    Fix(lmp, narg, arg), outer_forces_(OuterForces::as_a_whole), spin_(FROZEN), objects_(nullptr), law_(nullptr), impulse_(nullptr), ahead_(nullptr)
{
  time_integrate = 1;
  comm_forward = OUTER_SIZE;
}

void FixObjectIntegrator::declare_spin(swellflow::Options &options)
{
  options.choice("spin", spin_, {"frozen", "body"}, "whether contact detection spheres turn with their object, and hand it their torque");
}

int FixObjectIntegrator::setmask() { return INITIAL_INTEGRATE | FINAL_INTEGRATE; }

void FixObjectIntegrator::post_create() { objects_ = require_objects(lmp, *this); }

void FixObjectIntegrator::init()
{
  objects_ = require_objects(lmp, *this);
  require_one_integrator(lmp, *this);
}

void FixObjectIntegrator::setup(int)
{
  objects_->require_whole_objects(*this);
  require_points_only();
}

/// Other atoms of the group would silently stay where they are.
void FixObjectIntegrator::require_points_only() const
{
  int others = 0;
  for (int i = 0; i < atom->nlocal; i++) others += (atom->mask[i] & groupbit) && !objects_->is_point(i);
  MPI_Allreduce(MPI_IN_PLACE, &others, 1, MPI_INT, MPI_SUM, world);
  if (others > 0)
    error->fix_error(FLERR, const_cast<FixObjectIntegrator *>(this),
                     ("it moves points of objects, but " + std::to_string(others) + " atoms of its group are none: give it a group of objects, and move the others by their own fix, such as nve/sphere").c_str());
}

bool FixObjectIntegrator::acts_on(const ObjectPoints &object) const { return atom->mask[object.hub] & groupbit; }

bool FixObjectIntegrator::hub_is_held(const ObjectPoints &object) const { return objects_->points()[object.hub][FixObjects::SPOKES] != 0.0; }

/// visit(n, i): the n-th point of the body is atom i, own or image; ring points, then the hub when it is held.
template <typename Visit>
void FixObjectIntegrator::for_each_member(const ObjectPoints &object, const Visit &visit) const
{
  for (int k = 0; k < object.n_ring; k++) visit(k, object.ring[k]);
  if (hub_is_held(object)) visit(object.n_ring, object.hub);
}

/* ---------------------------------------------------------------------- */

void FixObjectIntegrator::initial_integrate(int)
{
  swellflow::StepClock::Scope timing(objects_->clock(), swellflow::StepClock::integration);
  take_back_foreseen();
  collect_outer();
  for (const ObjectPoints &object : objects_->objects()) {
    if (!acts_on(object)) continue;
    const double origin[2] = {atom->x[object.hub][0], atom->x[object.hub][1]};
    const double torque = gather(object);
    if (impulse_) begin_ahead(object, torque);
    kick_half_a_step(torque);
    move(object, body_, excess_);
    scatter_positions(object, origin);
    scatter_velocities(object);
    if (impulse_) foresee_impulse(object);
  }
}

void FixObjectIntegrator::final_integrate()
{
  swellflow::StepClock::Scope timing(objects_->clock(), swellflow::StepClock::integration);
  collect_outer();
  for (const ObjectPoints &object : objects_->objects()) {
    if (!acts_on(object)) continue;
    kick_half_a_step(gather(object));
    scatter_velocities(object);
    if (impulse_) add_foreseen(object);
  }
}

/* ----------------------------------------------------------------------
   half of the fluid's impulse in this step, as it moves the object as a
   whole, is in the velocities between two steps
------------------------------------------------------------------------- */

void FixObjectIntegrator::foresee_impulse(const ObjectPoints &object)
{
  body_.force = body_.impulse;
  const swellflow::WholeMotion whole = whole_motion(body_);
  const swellflow::RigidAcceleration change = rigid_acceleration(body_, whole, 0.0);
  for_each_member(object, [&](int n, int i) {
    const int own = objects_->own_index(i);
    if (own < 0) return;
    const Vector2 ahead = 0.5 * change.at(body_.x[n] - whole.centre);
    for (int d = 0; d < 2; d++) ahead_[own][FluidAhead::AHEAD_X + d] = ahead[d];
    ahead_[own][FluidAhead::KNOWS_AHEAD] = 1.0;
  });
}

/// A velocity that was given, not computed, is one between two steps too.
void FixObjectIntegrator::begin_ahead(const ObjectPoints &object, double torque)
{
  bool known = false;
  for_each_member(object, [&](int, int i) {
    const int own = objects_->own_index(i);
    known = known || (own >= 0 && ahead_[own][FluidAhead::KNOWS_AHEAD] != 0.0);
  });
  if (known) return;
  swellflow::WholeMotion whole = whole_motion(body_);
  const swellflow::RigidAcceleration outer = rigid_acceleration(body_, whole, torque);
  whole.velocity += update->dt * outer.linear;
  whole.angular_momentum += update->dt * outer.angular * whole.inertia;
  const swellflow::RigidAcceleration drag = drag_as_a_whole(body_, whole, update->dt);
  for (int n = 0; n < body_.size(); n++) body_.v[n] -= 0.5 * update->dt * drag.at(body_.x[n] - whole.centre);
}

void FixObjectIntegrator::add_foreseen(const ObjectPoints &object)
{
  for_each_member(object, [&](int, int i) {
    const int own = objects_->own_index(i);
    for (int d = 0; own >= 0 && d < 2; d++) atom->v[own][d] += ahead_[own][FluidAhead::AHEAD_X + d];
  });
}

void FixObjectIntegrator::take_back_foreseen()
{
  double **columns = fluid_columns(lmp, FluidAhead::NAME);
  if (!columns) return;
  for (int i = 0; i < atom->nlocal; i++)
    if (atom->mask[i] & groupbit)
      for (int d = 0; d < 2; d++) {
        double &ahead = columns[i][FluidAhead::AHEAD_X + d];
        atom->v[i][d] -= ahead;
        ahead = 0.0;
      }
}

/// Sets excess_, too. `torque`: of the spheres, which turns the object as a whole in any case.
void FixObjectIntegrator::kick_half_a_step(double torque)
{
  const bool as_a_whole = outer_forces_ == OuterForces::as_a_whole;
  const swellflow::WholeMotion whole = whole_motion(body_);
  const swellflow::RigidAcceleration rigid = as_a_whole ? rigid_acceleration(body_, whole, torque) : swellflow::RigidAcceleration{{0.0, 0.0}, torque / whole.inertia};
  excess_.assign(body_.size(), Vector2::Zero());
  for (int n = 0; n < body_.size(); n++) {
    Vector2 acceleration = rigid.at(body_.x[n] - whole.centre);
    if (as_a_whole) excess_[n] = body_.force[n] - body_.mass[n] * acceleration;
    else acceleration += body_.force[n] / body_.mass[n];
    body_.v[n] += 0.5 * update->dt * acceleration;
  }
}

/* ----------------------------------------------------------------------
   forces, velocities and the fluid's law of own points, and of images by
   their owners
------------------------------------------------------------------------- */

void FixObjectIntegrator::collect_outer()
{
  law_ = fluid_columns(lmp, FluidLaw::NAME);
  impulse_ = fluid_columns(lmp, FluidImpulse::NAME);
  ahead_ = fluid_columns(lmp, FluidAhead::NAME);
  if (!law_ || !impulse_ || !ahead_) law_ = impulse_ = ahead_ = nullptr;
  outer_.resize(atom->nlocal + atom->nghost);
  for (int i = 0; i < atom->nlocal; i++) {
    const double *f = atom->f[i], *v = atom->v[i], *law = law_ ? law_[i] : nullptr;
    outer_[i] = {f[0] * force->ftm2v, f[1] * force->ftm2v, spin_ == BODY ? atom->torque[i][2] * force->ftm2v : 0.0, v[0], v[1],
                 law ? law[FluidLaw::KAPPA] : 0.0, law ? law[FluidLaw::A_X] : 0.0, law ? law[FluidLaw::A_Y] : 0.0};
  }
  comm->forward_comm_fix(this);
}

int FixObjectIntegrator::pack_comm(int n, int *list, double *buf, int, int *)
{
  auto *out = reinterpret_cast<Outer *>(buf);
  for (int k = 0; k < n; k++) out[k] = outer_[list[k]];
  return OUTER_SIZE;
}

void FixObjectIntegrator::unpack_comm(int n, int first, double *buf)
{
  const auto *in = reinterpret_cast<const Outer *>(buf);
  std::copy(in, in + n, outer_.begin() + first);
}

/// Fills body_, positions relative to the hub; returns the torque on its spheres.
double FixObjectIntegrator::gather(const ObjectPoints &object)
{
  const double *hub = atom->x[object.hub];
  double torque = 0.0;
  body_.resize(object.n_ring + hub_is_held(object), law_ != nullptr);
  for_each_member(object, [&](int n, int i) {
    const Outer &outer = outer_[i];
    body_.x[n] = {atom->x[i][0] - hub[0], atom->x[i][1] - hub[1]};
    body_.v[n] = {outer.vx, outer.vy};
    body_.mass[n] = atom->rmass[i];
    body_.force[n] = {outer.fx, outer.fy};
    torque += outer.torque;
    if (!law_) return;
    body_.kappa[n] = outer.kappa;
    body_.a[n] = {outer.ax, outer.ay};
    body_.impulse[n].setZero();
  });
  return torque;
}

/* ----------------------------------------------------------------------
   to own points; the images' own atoms may lie across a periodic box
------------------------------------------------------------------------- */

void FixObjectIntegrator::scatter_positions(const ObjectPoints &object, const double *origin)
{
  for_each_member(object, [&](int n, int i) {
    const int own = objects_->own_index(i);
    if (own < 0) return;
    const double shift[2] = {atom->x[own][0] - atom->x[i][0], atom->x[own][1] - atom->x[i][1]};
    for (int d = 0; d < 2; d++) atom->x[own][d] = origin[d] + shift[d] + body_.x[n][d];
    if (impulse_)
      for (int d = 0; d < 2; d++) impulse_[own][d] += body_.impulse[n][d];
  });
}

void FixObjectIntegrator::scatter_velocities(const ObjectPoints &object)
{
  const double spin = spin_ == BODY ? whole_motion(body_).spin() : 0.0;
  for_each_member(object, [&](int n, int i) {
    const int own = objects_->own_index(i);
    if (own < 0) return;
    for (int d = 0; d < 2; d++) atom->v[own][d] = body_.v[n][d];
    if (spin_ == BODY) atom->omega[own][2] = spin;
  });
}
