#include "fix_nve_cds.h"

#include <optional>
#include <string>

#include "atom.h"
#include "fix_objects.h"
#include "fluid_columns.h"
#include "force.h"
#include "integrators.h"
#include "options.h"
#include "update.h"

using namespace LAMMPS_NS;
using namespace FixConst;
using swellflow::FluidImpulse;
using swellflow::FluidLaw;

FixNveCds::FixNveCds(LAMMPS *lmp, int narg, char **arg) : Fix(lmp, narg, arg)
{
  swellflow::or_stop(lmp, [&] {
    swellflow::Arguments line(std::string("fix ") + id + " nve/cds", narg - 3, arg + 3);
    swellflow::Options(line.place()).parse(line);
  });
  time_integrate = 1;
}

int FixNveCds::setmask() { return INITIAL_INTEGRATE | FINAL_INTEGRATE; }

void FixNveCds::init()
{
  require_one_integrator(lmp, *this);
  forget_what_is_ahead(lmp, *this);
}

void FixNveCds::initial_integrate(int) { half_step<Part::kick_and_drift>(); }

void FixNveCds::final_integrate() { half_step<Part::kick>(); }

/* ---------------------------------------------------------------------- */

double FixNveCds::mass_of(int i) const { return atom->rmass ? atom->rmass[i] : atom->mass[atom->type[i]]; }

/* ----------------------------------------------------------------------
   kick and drift in one pass: beds do not fit into the cache
------------------------------------------------------------------------- */

template <FixNveCds::Part part>
void FixNveCds::half_step()
{
  std::optional<swellflow::StepClock::Scope> timing;
  FixObjects *objects = find_objects(lmp);
  if (objects) timing.emplace(objects->clock(), swellflow::StepClock::integration);
  double **law = fluid_columns(lmp, FluidLaw::NAME), **impulse = fluid_columns(lmp, FluidImpulse::NAME);
  const bool some_follow = objects && objects->some_follow_their_ring();
  dt_ = update->dt;
  half_step_ = 0.5 * dt_ * force->ftm2v;
  for (int i = 0; i < atom->nlocal; i++) {
    if (!(atom->mask[i] & groupbit)) continue;
    if (some_follow && objects->follows_its_ring(i)) {
      if (part == Part::kick_and_drift) drift(i);
    } else if (law && impulse) {
      half_step_in_fluid<part>(i, mass_of(i), law[i], impulse[i]);
    } else {
      half_step_of<part>(i, mass_of(i));
    }
  }
}

template <FixNveCds::Part part>
void FixNveCds::half_step_of(int i, double mass)
{
  const double per_mass = half_step_ / mass, dt = dt_, *f = atom->f[i];
  double *v = atom->v[i], *x = atom->x[i];
  for (int d = 0; d < 3; d++) {
    const double v_new = v[d] + per_mass * f[d];
    v[d] = v_new;
    if (part == Part::kick_and_drift) x[d] += dt * v_new;
  }
}

/* ----------------------------------------------------------------------
   m (v' - v) = dt/2 (f + a - kappa v'), the fluid's part summed up
------------------------------------------------------------------------- */

template <FixNveCds::Part part>
void FixNveCds::half_step_in_fluid(int i, double mass, const double *law, double *impulse)
{
  const double kappa = law[FluidLaw::KAPPA], *a = law + FluidLaw::A_X, *f = atom->f[i];
  const double half_step = half_step_, dt = dt_, half_dt = 0.5 * dt, per_mass = 1.0 / (mass + half_step * kappa);
  double *v = atom->v[i], *x = atom->x[i];
  for (int d = 0; d < 3; d++) {
    const double a_d = a[d], v_new = (mass * v[d] + half_step * (f[d] + a_d)) * per_mass;
    v[d] = v_new;
    impulse[d] += half_dt * (a_d - kappa * v_new);
    if (part == Part::kick_and_drift) x[d] += dt * v_new;
  }
}

void FixNveCds::drift(int i)
{
  for (int d = 0; d < 3; d++) atom->x[i][d] += dt_ * atom->v[i][d];
}
