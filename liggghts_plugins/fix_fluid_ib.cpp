#include "fix_fluid_ib.h"

#include <cstring>
#include <string>

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "fix_gravity.h"
#include "fix_objects.h"
#include "fix_property_atom.h"
#include "fix_swell.h"
#include "fluid_columns.h"
#include "force.h"
#include "modify.h"
#include "options.h"
#include "update.h"

using namespace LAMMPS_NS;
using namespace swellflow;

FixFluidIb::FixFluidIb(LAMMPS *lmp, int narg, char **arg, const FluidPartnerFactory &make_partner) :
  Fix(lmp, narg, arg), make_partner_(make_partner)
{
  or_stop(lmp, [&] { parse(narg, arg); });
  nevery = 1;
  scalar_flag = vector_flag = 1;
  size_vector = 9;
  global_freq = 1;
  time_depend = 1;
  extscalar = extvector = 0;
  for (int i = 0; i < modify->nfix; i++) {
    const Fix *other = modify->fix[i];  // null: the fix of the same ID that this one replaces
    if (other && strcmp(other->style, style) == 0 && strcmp(other->id, id) != 0)
      error->fix_error(FLERR, this, ("a scene has one fluid, but fix " + std::string(other->id) + " is one already: unfix it first").c_str());
  }
}

void FixFluidIb::parse(int narg, char **arg)
{
  const std::string place = std::string("fix ") + arg[0] + " fluid/ib";
  Arguments arguments(place, narg - 3, arg + 3);
  Options options(place);
  options.custom("cells", [&](Arguments &words) {
    for (int d = 0; d < 2; d++) options_.cells[d] = words.integer("cells", Range::at_least(4));
  }, "NX NY: cells across the box").required();
  options.number("density", options_.density, Range::positive(), "mass/length^3", "density of the fluid").required();
  options.number("viscosity", options_.kinematic_viscosity, Range::positive(), "length^2/time", "kinematic viscosity").required();
  options.integer("every", options_.dem_steps_per_fluid_step, Range::at_least(1), "DEM steps in a fluid step");
  options.number("retraction", options_.retraction, Range::not_negative(), "cells", "of the markers, from the ring point towards the hub");
  options.number("marker_gap", options_.marker_gap, Range::positive(), "cells", "largest natural distance of markers along a ring");
  std::array<bool, 4> named{};
  options.custom("wall", [&](Arguments &words) {
    const std::vector<std::string> sides = {"xlo", "xhi", "ylo", "yhi"};
    const int side = words.choice("wall", sides);
    if (named[side]) words.fail("each wall is described once, but " + sides[side] + " is here twice: take one of them out");
    named[side] = true;
    words.choice("wall", {"velocity"});
    for (int d = 0; d < 2; d++) options_.wall_velocity[side][d] = words.number("wall velocity", Range::any(), "length/time");
    if (options_.wall_velocity[side][side / 2] != 0.0)
      words.fail("a wall moves within its plane, but the normal component of its velocity is " +
                 shown(options_.wall_velocity[side][side / 2]) + ": set it to 0");
  }, "SIDE velocity VX VY: a wall that moves within its plane").repeatable();
  options.parse(arguments);
}

int FixFluidIb::setmask()
{
  return FixConst::PRE_INITIAL_INTEGRATE | FixConst::POST_FORCE | FixConst::END_OF_STEP;
}

/* ----------------------------------------------------------------------
   the per-atom vectors that integrators and the coupling share.
   A restart file does not hold the fluid, so it does not hold them either.
------------------------------------------------------------------------- */

void FixFluidIb::post_create()
{
  make_property(FluidLaw::NAME, FluidLaw::N_COLUMNS, false);
  make_property(FluidImpulse::NAME, FluidImpulse::N_COLUMNS, false);
  carried_ = make_property(FluidCarried::NAME, FluidCarried::N_COLUMNS, true);
  make_property(FluidState::NAME, FluidState::N_COLUMNS, false);
}

FixPropertyAtom *FixFluidIb::make_property(const char *name, int columns, bool on_ghosts)
{
  std::vector<const char *> words = {name, "all", "property/atom", name, "vector", "no", on_ghosts ? "yes" : "no", "no"};
  words.resize(words.size() + columns, "0");
  std::vector<char *> arguments;
  for (const char *word : words) arguments.push_back(const_cast<char *>(word));
  modify->add_fix(arguments.size(), arguments.data());
  return static_cast<FixPropertyAtom *>(modify->fix[modify->find_fix(name)]);
}

void FixFluidIb::pre_delete(bool unfixflag)
{
  if (!unfixflag) return;
  for (const char *name : {FluidLaw::NAME, FluidImpulse::NAME, FluidCarried::NAME, FluidState::NAME})
    if (modify->find_fix(name) >= 0) modify->delete_fix(name);
}

/* ---------------------------------------------------------------------- */

void FixFluidIb::init()
{
  require_settings();
  require_integrators();
  if (!partner_) make_partner();
  // LIGGGHTS sorts atoms by the cut-off of the pair style, and stops where there is none.
  if (!force->pair) atom->sortfreq = 0;
}

void FixFluidIb::make_partner()
{
  or_stop(lmp, [&] {
    try {
      partner_ = make_partner_(lmp, options_);
    } catch (const std::invalid_argument &refusal) {
      throw OptionError(std::string("fix ") + id + " fluid/ib: " + refusal.what());
    }
  });
}

void FixFluidIb::require_settings()
{
  if (domain->dimension != 2)
    error->fix_error(FLERR, this, "the fluid is two-dimensional, but the dimension is 3: use 'dimension 2'");
  if (domain->triclinic || domain->box_change)
    error->fix_error(FLERR, this, "the fluid's box must be a fixed rectangle, but it is tilted or changes: use an orthogonal box and no fix deform");
  for (int d = 0; d < 2; d++)
    for (int end = 0; end < 2; end++)
      if (domain->boundary[d][end] != 1) {
        const char *kinds[] = {"p", "f", "s", "m"};
        const std::string message = std::string("each side of the fluid must be a wall at a fixed place, but boundary ") + "xy"[d] + " is '" +
                                    kinds[domain->boundary[d][end]] + "': use 'boundary f f p'";
        error->fix_error(FLERR, this, message.c_str());
      }
  if (!comm->ghost_velocity)
    error->fix_error(FLERR, this, "ranks must know the velocities of each other's points, but ghosts have none: add 'communicate single vel yes'");
  for (const char *name : {FluidLaw::NAME, FluidImpulse::NAME, FluidCarried::NAME, FluidState::NAME})
    if (modify->find_fix(name) < 0)
      error->fix_error(FLERR, this, ("the fluid keeps its state in fix '" + std::string(name) + "', which is gone: do not unfix it").c_str());
}

/* ----------------------------------------------------------------------
   only integrators that know the fluid's law let the points feel it
------------------------------------------------------------------------- */

void FixFluidIb::require_integrators()
{
  const FixObjects *known = find_objects(lmp);
  if (!known) return;
  int missing = 0;
  for (int i = 0; i < atom->nlocal; i++) {
    if (!known->is_point(i)) continue;
    bool moved = false;
    for (int k = 0; k < modify->nfix; k++)
      moved = moved || (strcmp(modify->fix[k]->style, "nve/cds") == 0 && (atom->mask[i] & modify->fix[k]->groupbit));
    if (!moved) missing = 1;
  }
  int missing_anywhere = 0;
  MPI_Allreduce(&missing, &missing_anywhere, 1, MPI_INT, MPI_MAX, world);
  if (missing_anywhere)
    error->fix_error(FLERR, this, "each object in the fluid needs an integrator that knows the fluid's force, but some have none: "
                                  "add 'fix ID all nve/cds' in place of other nve styles");
}

void FixFluidIb::setup(int vflag)
{
  const FixObjects *known = find_objects(lmp);
  if (known) known->require_whole_objects(*this);
  require_same_step();
  partner_->weigh(objects(), gravity());
  post_force(vflag);
}

/* ---------------------------------------------------------------------- */

/* ----------------------------------------------------------------------
   the law of a fluid step under way was made for its time step
------------------------------------------------------------------------- */

void FixFluidIb::require_same_step()
{
  if (dem_step_ > 0 && update->dt != dt_) {
    const std::string message = "the time step may change between fluid steps only, but it goes from " + shown(dt_) + " to " + shown(update->dt) +
                                " after " + std::to_string(dem_step_) + " of " + std::to_string(options_.dem_steps_per_fluid_step) +
                                " DEM steps: let the run before end with a multiple of 'every'";
    error->fix_error(FLERR, this, message.c_str());
  }
}

void FixFluidIb::pre_initial_integrate()
{
  if (dem_step_ > 0) return;
  dt_ = update->dt;
  // Ghosts lag half a step behind in velocity. All ranks take part, those without ghosts too.
  comm->forward_comm();
  carried_->do_forward_comm();
  partner_->begin_step(objects(), gravity());
}

void FixFluidIb::post_force(int)
{
  const int found = modify->find_fix(FluidState::NAME);
  double **state = static_cast<FixPropertyAtom *>(modify->fix[found])->array_atom;
  for (int i = 0; i < atom->nlocal; i++) {
    atom->f[i][0] += state[i][FluidState::BODY_FORCE_X];
    atom->f[i][1] += state[i][FluidState::BODY_FORCE_Y];
  }
}

void FixFluidIb::end_of_step()
{
  if (++dem_step_ < options_.dem_steps_per_fluid_step) return;
  dem_step_ = 0;
  partner_->finish_step(objects());
  reported_step_ = -1;
}

const std::vector<ObjectPoints> &FixFluidIb::objects()
{
  objects_.clear();
  const FixObjects *known = find_objects(lmp);
  if (!known) return objects_;
  objects_ = known->objects();
  for (int k = 0; k < modify->nfix; k++) {
    const auto *swell = dynamic_cast<FixSwell *>(modify->fix[k]);
    if (!swell || !swell->absorbs()) continue;
    for (auto &object : objects_)
      if (atom->mask[object.hub] & swell->groupbit) object.absorbs = true;
  }
  return objects_;
}

std::array<double, 3> FixFluidIb::gravity() const
{
  std::array<double, 3> sum{};
  for (int k = 0; k < modify->nfix; k++) {
    auto *fix = dynamic_cast<FixGravity *>(modify->fix[k]);
    if (!fix) continue;
    std::array<double, 3> g{};
    fix->get_gravity(g.data());
    for (int d = 0; d < 3; d++) sum[d] += g[d];
  }
  return sum;
}

/* ---------------------------------------------------------------------- */

const FluidReport &FixFluidIb::report()
{
  if (partner_ && reported_step_ != update->ntimestep) {
    report_ = partner_->report();
    reported_step_ = update->ntimestep;
  }
  return report_;
}

double FixFluidIb::compute_scalar() { return report().kinetic_energy; }

double FixFluidIb::compute_vector(int n)
{
  const FluidReport &now = report();
  const double values[] = {now.mean_slip, now.max_slip, now.max_divergence, now.cfl, now.kinetic_energy,
                           now.force_on_objects[0], now.force_on_objects[1], now.momentum_error, now.marker_gap};
  return values[n];
}
