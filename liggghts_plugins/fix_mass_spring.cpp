#include "fix_mass_spring.h"

#include <algorithm>
#include <cmath>

#include "atom.h"
#include "comm.h"
#include "error.h"
#include "fix_objects.h"
#include "fix_property_atom.h"
#include "modify.h"
#include "options.h"
#include "update.h"

using namespace LAMMPS_NS;
using namespace FixConst;
using swellflow::ObjectPoints;
using swellflow::Range;
using swellflow::Vector2;

namespace {

Vector2 plane(const double *x) { return {x[0], x[1]}; }

}  // namespace

/* ---------------------------------------------------------------------- */

FixMassSpring::FixMassSpring(LAMMPS *lmp, int narg, char **arg) :
    Fix(lmp, narg, arg), restitution_(1.0), objects_(nullptr), dashpot_(nullptr), dashpot_step_(-1), totals_step_(-1)
{
  swellflow::or_stop(lmp, [&] {
    swellflow::Arguments line(std::string("fix ") + id + " mass_spring", narg - 3, arg + 3);
    swellflow::Options options(line.place());
    options.number("stiffness", law_.stiffness, Range::positive(), "force per length", "stiffness of every spring").required();
    options.number("restitution", restitution_, Range::above_to(0.0, 1.0), "", "speed after over speed before, for a bonded pair");
    options.parse(line);
  });
  law_.damping = swellflow::damping_ratio(restitution_);
  restart_global = 1;
  scalar_flag = vector_flag = 1;
  size_vector = 4;
  global_freq = 1;
  extscalar = 1;
  extvector = 0;
}

int FixMassSpring::setmask() { return POST_FORCE; }

void FixMassSpring::post_create()
{
  objects_ = require_objects(lmp, *this);
  if (!damped() || modify->find_fix(dashpot_property().c_str()) >= 0) return;
  const std::string name = dashpot_property();
  const char *arguments[] = {name.c_str(), "all", "property/atom", name.c_str(), "vector", "yes", "no", "no", "0", "0"};
  modify->add_fix(10, const_cast<char **>(arguments));
  // LIGGGHTS would write the zeros again at the first run.
  modify->fix[modify->find_fix(name.c_str())]->just_created = 0;
}

void FixMassSpring::pre_delete(bool unfixflag)
{
  if (unfixflag && modify->find_fix(dashpot_property().c_str()) >= 0) modify->delete_fix(dashpot_property().c_str());
}

void FixMassSpring::init()
{
  objects_ = require_objects(lmp, *this);
  totals_step_ = -1;
  if (!damped()) return;
  dashpot_ = static_cast<FixPropertyAtom *>(modify->fix[modify->find_fix(dashpot_property().c_str())]);
  if (!comm->ghost_velocity)
    error->fix_error(FLERR, this, ("a dashpot needs its partner's velocity, but ghosts have none (restitution is " +
                                   swellflow::shown(restitution_) + "): add 'communicate single vel yes'").c_str());
}

/* ----------------------------------------------------------------------
   Within a step forces are made with the velocities of the half step,
   which are gone when a run begins: the dashpots' force is kept, so that
   a run in two parts, or from a restart file, is equal to one run.
------------------------------------------------------------------------- */

void FixMassSpring::setup(int)
{
  objects_->require_whole_objects(*this);
  add_springs();
  if (!damped()) return;
  if (dashpot_step_ != update->ntimestep) measure_dashpots();
  add_dashpots();
}

void FixMassSpring::post_force(int)
{
  swellflow::StepClock::Scope timing(objects_->clock(), swellflow::StepClock::springs);
  totals_step_ = -1;  // a variable may have asked for the values of this step before it came
  add_springs();
  if (!damped()) return;
  measure_dashpots();
  add_dashpots();
}

/* ---------------------------------------------------------------------- */

bool FixMassSpring::holds(const ObjectPoints &object) const { return atom->mask[object.hub] & groupbit; }

/// visit(a, b, natural length), each spring once; `a` is the ring point that the spring is stored with.
template <typename Visit>
void FixMassSpring::for_each_spring(const ObjectPoints &object, const Visit &visit) const
{
  double **points = objects_->points();
  swellflow::for_each_spring(object.n_ring, [&](int k, int other, bool is_spoke) {
    const int a = object.ring[k], b = is_spoke ? object.hub : object.ring[other];
    const double stored = points[a][is_spoke ? FixObjects::SPOKE_LENGTH : FixObjects::RING_LENGTH];
    visit(a, b, points[a][FixObjects::LAMBDA] * stored);
  });
}

void FixMassSpring::add_springs()
{
  double **x = atom->x, **f = atom->f;
  for (const ObjectPoints &object : objects_->objects()) {
    if (!holds(object)) continue;
    for_each_spring(object, [&](int a, int b, double L) {
      add_pair(f, a, b, swellflow::spring_force(plane(x[a]), plane(x[b]), L, law_.stiffness));
    });
  }
}

void FixMassSpring::measure_dashpots()
{
  double **x = atom->x, **v = atom->v, **dashpot = dashpot_->array_atom;
  for (int i = 0; i < atom->nlocal; i++) dashpot[i][0] = dashpot[i][1] = 0.0;
  for (const ObjectPoints &object : objects_->objects()) {
    if (!holds(object)) continue;
    for_each_spring(object, [&](int a, int b, double) {
      const double c = law_.dashpot(atom->rmass[a], atom->rmass[b]);
      add_pair(dashpot, a, b, swellflow::dashpot_force(plane(x[a]), plane(x[b]), plane(v[a]), plane(v[b]), c));
    });
  }
  dashpot_step_ = update->ntimestep;
}

void FixMassSpring::add_dashpots()
{
  for (int i = 0; i < atom->nlocal; i++)
    for (int d = 0; d < 2; d++) atom->f[i][d] += dashpot_->array_atom[i][d];
}

/* ----------------------------------------------------------------------
   to the own atoms of a pair; a point may be here as an image while its
   own atom lies at the other side of a periodic box
------------------------------------------------------------------------- */

void FixMassSpring::add_pair(double **force, int a, int b, const Vector2 &F) const
{
  const int own_a = objects_->own_index(a), own_b = objects_->own_index(b);
  if (own_a >= 0) force[own_a][0] += F.x(), force[own_a][1] += F.y();
  if (own_b >= 0) force[own_b][0] -= F.x(), force[own_b][1] -= F.y();
}

/* ---------------------------------------------------------------------- */

void FixMassSpring::reset_timestep(bigint new_step, bigint old_step)
{
  if (dashpot_step_ >= 0) dashpot_step_ += new_step - old_step;
}

void FixMassSpring::write_restart(FILE *fp)
{
  if (comm->me != 0) return;
  const double state = static_cast<double>(dashpot_step_);
  const int size = sizeof state;
  fwrite(&size, sizeof(int), 1, fp);
  fwrite(&state, sizeof(double), 1, fp);
}

void FixMassSpring::restart(char *buffer) { dashpot_step_ = static_cast<bigint>(*reinterpret_cast<double *>(buffer)); }

/* ----------------------------------------------------------------------
   values for thermo: each spring is counted by the rank of its ring point
------------------------------------------------------------------------- */

double FixMassSpring::step_over_limit(const ObjectPoints &object) const
{
  const double *m = atom->rmass;
  const double omega_squared =
      swellflow::largest_omega_squared(law_.stiffness, object.n_ring, m[object.ring[0]], m[object.hub]);
  return 0.5 * update->dt * std::sqrt(omega_squared);
}

const FixMassSpring::Totals &FixMassSpring::totals()
{
  if (totals_step_ == update->ntimestep) return totals_;
  double **x = atom->x, **v = atom->v;
  double sums[2] = {0.0, 0.0}, largest[2] = {0.0, 0.0};
  const bool current = objects_->current();
  for (std::size_t k = 0; current && k < objects_->objects().size(); k++) {
    const ObjectPoints &object = objects_->objects()[k];
    if (!holds(object)) continue;
    largest[1] = std::max(largest[1], step_over_limit(object));
    for_each_spring(object, [&](int a, int b, double L) {
      if (objects_->own_index(a) < 0) return;
      const Vector2 d = plane(x[a]) - plane(x[b]);
      const double stretch = d.norm() - L;
      sums[0] += 0.5 * law_.stiffness * stretch * stretch;
      largest[0] = std::max(largest[0], std::abs(stretch) / L);
      if (!damped()) return;
      const double closing = (plane(v[a]) - plane(v[b])).dot(swellflow::direction(plane(x[a]), plane(x[b])));
      sums[1] += law_.dashpot(atom->rmass[a], atom->rmass[b]) * closing * closing;
    });
  }
  MPI_Allreduce(MPI_IN_PLACE, sums, 2, MPI_DOUBLE, MPI_SUM, world);
  MPI_Allreduce(MPI_IN_PLACE, largest, 2, MPI_DOUBLE, MPI_MAX, world);
  totals_ = {.energy = sums[0], .largest_strain = largest[0], .dissipated_power = sums[1], .step_over_limit = largest[1]};
  totals_step_ = update->ntimestep;
  return totals_;
}

double FixMassSpring::compute_scalar() { return totals().energy; }

double FixMassSpring::compute_vector(int n)
{
  const Totals &now = totals();
  const double values[] = {now.energy, now.largest_strain, now.dissipated_power, now.step_over_limit};
  return values[n];
}
