#include "fix_fluid_ib.h"

#include <algorithm>
#include <cstring>
#include <string>

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "fix_checkpoint.h"
#include "fix_mass_spring.h"
#include "fix_objects.h"
#include "fix_property_atom.h"
#include "fix_swell.h"
#include "fluid_columns.h"
#include "force.h"
#include "gravity.h"
#include "guard.h"
#include "memory_room.h"
#include "modify.h"
#include "options.h"
#include "output.h"
#include "per_atom_values.h"
#include "restart_lines.h"
#include "say.h"
#include "update.h"

using namespace LAMMPS_NS;
using namespace swellflow;

FixFluidIb::FixFluidIb(LAMMPS *lmp, int narg, char **arg, const FluidPartnerFactory &make_partner, const AccuracyPreset &accuracy) :
  Fix(lmp, narg, arg), make_partner_(make_partner), phases_(lmp), stop_(lmp)
{
  or_stop(lmp, [&] { parse(narg, arg, accuracy); });
  nevery = 1;
  scalar_flag = vector_flag = 1;
  size_vector = 21;
  global_freq = 1;
  time_depend = 1;
  extscalar = extvector = 0;
  for (int i = 0; i < modify->nfix; i++) {
    const Fix *other = modify->fix[i];  // null: the fix of the same ID that this one replaces
    if (other && strcmp(other->style, style) == 0 && strcmp(other->id, id) != 0)
      error->fix_error(FLERR, this, ("a scene has one fluid, but fix " + std::string(other->id) + " is one already: unfix it first").c_str());
  }
}

void FixFluidIb::parse(int narg, char **arg, const AccuracyPreset &accuracy)
{
  Arguments line(std::string("fix ") + arg[0] + " fluid/ib", narg - 3, arg + 3);
  FluidScript::Box box;
  for (int d = 0; d < 2; d++) {
    box.periodic[d] = domain->periodicity[d] != 0;
    box.length[d] = domain->prd[d];
    box_low_[d] = domain->boxlo[d];
    box_high_[d] = domain->boxhi[d];
  }
  box.smallest_object = [this] { return smallest_object(); };
  script_ = std::make_unique<FluidScript>(line, box, accuracy);
  if (!script_->remark().empty()) say(lmp, script_->remark());
  constexpr double bytes_a_cell = 100.0;  // of a fluid without objects and scalars
  const auto &cells = script_->options().cells;
  require_memory(world, line.place(), std::to_string(cells[0]) + " x " + std::to_string(cells[1]) + " cells", bytes_a_cell * cells[0] * cells[1]);
}

int FixFluidIb::setmask()
{
  return FixConst::PRE_INITIAL_INTEGRATE | FixConst::END_OF_STEP;
}

/* ----------------------------------------------------------------------
   the per-atom vectors that integrators and the coupling share
------------------------------------------------------------------------- */

void FixFluidIb::post_create()
{
  law_ = add_per_atom_values(lmp, FluidLaw::NAME, FluidLaw::N_COLUMNS, true);
  add_per_atom_values(lmp, FluidImpulse::NAME, FluidImpulse::N_COLUMNS, false);
  ahead_ = add_per_atom_values(lmp, FluidAhead::NAME, FluidAhead::N_COLUMNS, true);
  carried_ = add_per_atom_values(lmp, FluidCarried::NAME, FluidCarried::N_COLUMNS, true);
  add_per_atom_values(lmp, FluidHome::NAME, FluidHome::N_COLUMNS, false);
  add_per_atom_values(lmp, FluidState::NAME, FluidState::N_COLUMNS, false);
}

void FixFluidIb::pre_delete(bool unfixflag)
{
  if (!unfixflag) return;
  for (const char *name : swellflow::fluid_column_names)
    if (modify->find_fix(name) >= 0) modify->delete_fix(name);
}

/* ---------------------------------------------------------------------- */

void FixFluidIb::init()
{
  require_settings();
  require_integrators();
  or_stop(lmp, [this] { script_->require_variables(lmp); });
  require_way_out();
  warn_without_resistance();
  if (!partner_) make_partner();
  // LIGGGHTS sorts atoms by the cut-off of the pair style, and stops where there is none.
  if (!force->pair) atom->sortfreq = 0;
}

void FixFluidIb::make_partner()
{
  or_stop(lmp, [&] {
    FluidOptions options = script_->options();
    // Whether a new compute has been invoked yet is whatever its memory held, on each rank another value, until this is called.
    modify->clearstep_compute();
    options.initial_velocity = script_->initial_velocity(lmp);
    options.initial_side_velocity = script_->drive(lmp).side_velocity;
    try {
      partner_ = make_partner_(lmp, options);
      continue_from_file();
    } catch (const std::invalid_argument &refusal) {
      throw OptionError(std::string("fix ") + id + " fluid/ib: " + refusal.what());
    }
  });
}

/// What the scene's restart file holds of a fluid, if this one comes before its first run.
void FixFluidIb::continue_from_file()
{
  const FixCheckpoint *checkpoint = find_checkpoint(lmp);
  if (!checkpoint || checkpoint->source().fluid_end <= checkpoint->source().fluid_begin) return;
  const CheckpointFile &file = checkpoint->source();
  partner_->load(file.name, file.fluid_begin, file.fluid_end);
}

void FixFluidIb::setup(int)
{
  run_end_ = update->laststep;
  worst_ = {};
  slip_.begin();
  const FixObjects *known = find_objects(lmp);
  if (known) known->require_whole_objects(*this);
  require_same_step();
}

/* ---------------------------------------------------------------------- */

void FixFluidIb::pre_initial_integrate()
{
  require_same_step();
  if (first_dem_step())
    begin_step();
  else if (has_heavy_objects_)
    partner_->press_again(objects(), dem_step_);
  if (last_dem_step()) stop_.look();
}

void FixFluidIb::begin_step()
{
  dt_ = update->dt;
  dem_steps_ = 1;
  dem_steps_ = partner_->choose_dem_steps(dt_, script_->options().cfl > 0.0 ? drive() : FluidDrive{});
  if (chooses_steps()) dem_steps_ = up_to_next_stop(dem_steps_);
  // Ghosts lag half a step behind in velocity. All ranks take part, those without ghosts too.
  comm->forward_comm();
  carried_->do_forward_comm();
  note_outer_forces();
  ahead_->do_forward_comm();
  const FluidDrive now = drive();
  objects();
  note_springs();
  partner_->begin_step(objects_, now, dem_steps_);
  law_->do_forward_comm();
  partner_->complete_law(objects_, now);
}

/// A fluid step whose length is free ends with the run (those with 'pre no' go on with one), and where a restart file is due: the last two before that are of a length.
int FixFluidIb::up_to_next_stop(int dem_steps) const
{
  const bigint begin = update->ntimestep - 1;
  bigint left = run_end_ - begin;
  // LIGGGHTS names the step after the run where no file is due.
  if (const bigint file = next_restart(*output) - begin; file > 0 && !restart_lines(*output).empty()) left = left > 0 ? std::min(left, file) : file;
  if (left <= 0 || left >= 2 * dem_steps) return dem_steps;
  return left <= dem_steps ? static_cast<int>(left) : static_cast<int>((left + 1) / 2);
}

void FixFluidIb::note_outer_forces()
{
  for (int i = 0; i < atom->nlocal; i++)
    for (int d = 0; d < 2; d++) ahead_->array_atom[i][FluidAhead::OUTER_X + d] = atom->f[i][d] * force->ftm2v;
}

void FixFluidIb::end_of_step()
{
  if (++dem_step_ < dem_steps_) return;
  dem_step_ = 0;
  whole_steps_++;
  try {
    partner_->finish_step(objects());
  } catch (const NotFinite &what_happened) {
    end_run(lmp, *this, what_happened.what());
  }
  stop_.end_run_if_agreed();
  reported_step_ = -1;
  note_accuracy();
}

void FixFluidIb::post_run()
{
  constexpr long some_steps = 40;
  if (whole_steps_ > steps_before_run_) {
    worst_.add(report(), cell(), largest_speed_of_points());
    judge_slip(some_steps);
  }
  if (whole_steps_ > steps_before_run_) phases_.print(partner_->phase_times());
  steps_before_run_ = whole_steps_;
}

/* ----------------------------------------------------------------------
   what drives the coming fluid step, at its end: LIGGGHTS has already
   counted the first of its DEM steps
------------------------------------------------------------------------- */

FluidDrive FixFluidIb::drive()
{
  FluidDrive drive;
  const bigint end = update->ntimestep - 1 + dem_steps_;
  const auto evaluate = [&] { drive = script_->drive(lmp); };
  if (script_->varies())
    with_variables_at(lmp, end, end + 1, evaluate);
  else
    evaluate();
  drive.gravity = total_gravity(lmp);
  drive.some_inflate = inflating_swell() != nullptr;
  return drive;
}

const std::vector<ObjectPoints> &FixFluidIb::objects()
{
  objects_.clear();
  const FixObjects *known = find_objects(lmp);
  if (!known) return objects_;
  objects_ = known->objects();
  for (int k = 0; k < modify->nfix; k++) {
    const auto *swell = dynamic_cast<FixSwell *>(modify->fix[k]);
    if (!swell) continue;
    for (auto &object : objects_)
      if (atom->mask[object.hub] & swell->groupbit) (swell->absorbs() ? object.absorbs : object.inflates) = true;
  }
  return objects_;
}

/// Of objects that may be heavy for the fluid inside: their mass is beyond ten of a layer of cells at the outline. Collective.
void FixFluidIb::note_springs()
{
  const FixObjects *known = find_objects(lmp);
  int some = 0;
  for (std::size_t n = 0; n < objects_.size(); n++) {
    const int hub = objects_[n].hub;
    const double *point = known->points()[hub], *size = known->sizes()[hub];
    const double mass = point[FixObjects::OBJECT_MASS] * atom->rmass[hub] / size[FixObjects::MASS];
    if (mass < 10.0 * density() * cell() * objects_[n].n_ring * size[FixObjects::LAMBDA] * point[FixObjects::RING_LENGTH]) continue;
    some = 1;
    for (int k = 0; k < modify->nfix; k++)
      if (const auto *springs = dynamic_cast<const FixMassSpring *>(modify->fix[k]))
        objects_[n].spring_frequency = std::max(objects_[n].spring_frequency, springs->breathing_frequency(known->objects()[n]));
  }
  MPI_Allreduce(MPI_IN_PLACE, &some, 1, MPI_INT, MPI_MAX, world);
  has_heavy_objects_ = some;
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
                           now.force_on_objects[0], now.force_on_objects[1], now.momentum_error, now.marker_gap,
                           now.step, now.mean_velocity[0], now.mean_velocity[1], now.driving_force[0], now.driving_force[1],
                           now.force_of_sides[0], now.force_of_sides[1], now.momentum[0], now.momentum[1],
                           now.outflow, now.force_of_growth[0], now.force_of_growth[1]};
  return values[n];
}

FixFluidIb *LAMMPS_NS::find_fluid(LAMMPS *lmp)
{
  for (int k = 0; k < lmp->modify->nfix; k++)
    if (auto *fluid = dynamic_cast<FixFluidIb *>(lmp->modify->fix[k])) return fluid;
  return nullptr;
}
