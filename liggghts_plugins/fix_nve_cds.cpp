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

void FixNveCds::initial_integrate(int)
{
  kick_half_a_step();
  drift_a_step();
}

void FixNveCds::final_integrate() { kick_half_a_step(); }

/* ---------------------------------------------------------------------- */

double FixNveCds::mass_of(int i) const { return atom->rmass ? atom->rmass[i] : atom->mass[atom->type[i]]; }

void FixNveCds::kick_half_a_step()
{
  std::optional<swellflow::StepClock::Scope> timing;
  FixObjects *objects = find_objects(lmp);
  if (objects) timing.emplace(objects->clock(), swellflow::StepClock::integration);
  double **law = fluid_columns(lmp, FluidLaw::NAME), **impulse = fluid_columns(lmp, FluidImpulse::NAME);
  const bool some_follow = objects && objects->some_follow_their_ring();
  const double half_step = 0.5 * update->dt * force->ftm2v;
  for (int i = 0; i < atom->nlocal; i++) {
    if (!(atom->mask[i] & groupbit) || (some_follow && objects->follows_its_ring(i))) continue;
    if (law && impulse)
      kick_in_fluid(i, half_step, mass_of(i), law[i], impulse[i]);
    else
      kick(i, half_step, mass_of(i));
  }
}

void FixNveCds::kick(int i, double half_step, double mass)
{
  const double per_mass = half_step / mass;
  for (int d = 0; d < 3; d++) atom->v[i][d] += per_mass * atom->f[i][d];
}

/* ----------------------------------------------------------------------
   m (v' - v) = dt/2 (f + a - kappa v'), the fluid's part summed up
------------------------------------------------------------------------- */

void FixNveCds::kick_in_fluid(int i, double half_step, double mass, const double *law, double *impulse)
{
  const double kappa = law[FluidLaw::KAPPA], *a = law + FluidLaw::A_X;
  double *v = atom->v[i];
  const double per_mass = 1.0 / (mass + half_step * kappa);
  for (int d = 0; d < 3; d++) {
    v[d] = (mass * v[d] + half_step * (atom->f[i][d] + a[d])) * per_mass;
    impulse[d] += 0.5 * update->dt * (a[d] - kappa * v[d]);
  }
}

void FixNveCds::drift_a_step()
{
  for (int i = 0; i < atom->nlocal; i++)
    if (atom->mask[i] & groupbit)
      for (int d = 0; d < 3; d++) atom->x[i][d] += update->dt * atom->v[i][d];
}
