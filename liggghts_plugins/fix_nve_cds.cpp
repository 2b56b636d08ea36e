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
    // LIGGGHTS' rows lie one behind the other: their addresses need not be fetched.
    const Motion motion{atom->x[0] + 3 * i, atom->v[0] + 3 * i, atom->f[0] + 3 * i, mass_of(i)};
    if (some_follow && objects->follows_its_ring(i)) {
      if (part == Part::kick_and_drift) drift(i);
    } else if (law && impulse) {
      half_step_in_fluid<part>(motion, law[0] + i * FluidLaw::N_COLUMNS, impulse[0] + i * FluidImpulse::N_COLUMNS);
    } else {
      half_step_of<part>(motion);
    }
  }
}

template <FixNveCds::Part part>
void FixNveCds::half_step_of(const Motion &point) const
{
  const double per_mass = half_step_ / point.mass, dt = dt_;
  for (int d = 0; d < 3; d++) {
    const double v_new = point.v[d] + per_mass * point.f[d];
    point.v[d] = v_new;
    if (part == Part::kick_and_drift) point.x[d] += dt * v_new;
  }
}

/* ----------------------------------------------------------------------
   m (v' - v) = dt/2 (f + a - kappa v'), the fluid's part summed up
------------------------------------------------------------------------- */

template <FixNveCds::Part part>
void FixNveCds::half_step_in_fluid(const Motion &point, const double *law, double *impulse) const
{
  const double kappa = law[FluidLaw::KAPPA], *a = law + FluidLaw::A_X;
  const double mass = point.mass, half_step = half_step_, dt = dt_, half_dt = 0.5 * dt, per_mass = 1.0 / (mass + half_step * kappa);
  for (int d = 0; d < 3; d++) {
    const double a_d = a[d], v_new = (mass * point.v[d] + half_step * (point.f[d] + a_d)) * per_mass;
    point.v[d] = v_new;
    impulse[d] += half_dt * (a_d - kappa * v_new);
    if (part == Part::kick_and_drift) point.x[d] += dt * v_new;
  }
}

void FixNveCds::drift(int i)
{
  for (int d = 0; d < 3; d++) atom->x[i][d] += dt_ * atom->v[i][d];
}
