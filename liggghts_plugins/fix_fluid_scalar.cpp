#include "fix_fluid_scalar.h"

#include <algorithm>
#include <string>

#include "atom.h"
#include "error.h"
#include "fix_fluid_ib.h"
#include "fix_objects.h"
#include "fix_property_atom.h"
#include "guard.h"
#include "modify.h"
#include "object_geometry.h"
#include "objects/outline.h"
#include "options.h"
#include "per_atom_values.h"
#include "update.h"

using namespace LAMMPS_NS;
using namespace swellflow;

namespace {

/// The most that markers take in a fluid step of what they meet, as a layer around them, in cells: an object that meets next to nothing takes its due later.
constexpr double largest_layer = 0.1;

ScalarScript read(const Fix &fix, int narg, char **arg, LAMMPS *lmp)
{
  std::unique_ptr<ScalarScript> script;
  or_stop(lmp, [&] {
    Arguments line(std::string("fix ") + fix.id + " fluid/scalar", narg - 3, arg + 3);
    for (const char *taken : {"velocity", "pressure"})
      if (std::string(fix.id) == taken) line.fail("the id names the scalar's field, but '" + std::string(taken) + "' is a field of the fluid: use another id");
    script = std::make_unique<ScalarScript>(line);
  });
  return *script;
}

}  // namespace

FixFluidScalar::FixFluidScalar(LAMMPS *lmp, int narg, char **arg) :
  Fix(lmp, narg, arg), script_(read(*this, narg, arg, lmp)), property_(std::string("scalar_") + id)
{
  nevery = 1;
  scalar_flag = vector_flag = peratom_flag = 1;
  size_vector = N_VALUES;
  size_peratom_cols = 2;
  global_freq = peratom_freq = 1;
  extscalar = extvector = 0;
}

int FixFluidScalar::setmask() { return FixConst::END_OF_STEP; }

void FixFluidScalar::post_create() { state_ = add_per_atom_values(lmp, property_, N_COLUMNS, false); }

void FixFluidScalar::pre_delete(bool unfixflag)
{
  if (!unfixflag) return;
  if (modify->find_fix(property()) >= 0) modify->delete_fix(property());
  FixFluidIb *fluid = find_fluid(lmp);
  if (fluid && fluid->partner()) fluid->partner()->remove_scalar(id);
}

double **FixFluidScalar::points() const { return state_->array_atom; }

/* ---------------------------------------------------------------------- */

void FixFluidScalar::init()
{
  fluid_ = find_fluid(lmp);
  objects_ = find_objects(lmp);
  require_place();
  or_stop(lmp, [this] {
    std::array<SideKind, ScalarScript::N_SIDES> sides;
    for (int side = 0; side < ScalarScript::N_SIDES; side++) sides[side] = fluid_->side(side);
    script_.require(lmp, sides);
  });
  if (!fluid_->partner()->scalar(id)) make_scalar();
  scalar_ = fluid_->partner()->scalar(id);
  values_step_ = -1;
}

void FixFluidScalar::require_place()
{
  if (!fluid_) error->fix_error(FLERR, this, "a scalar is carried by a fluid, but there is no fix fluid/ib: add one above it");
  if (modify->find_fix(fluid_->id) > modify->find_fix(id))
    error->fix_error(FLERR, this, "the scalar follows the step that the fluid has made: put fix fluid/scalar below fix fluid/ib");
  if (modify->find_fix(property()) < 0)
    error->fix_error(FLERR, this, ("what objects know of the scalar is kept in fix '" + property_ + "', which is gone: do not unfix it").c_str());
}

/* ----------------------------------------------------------------------
   objects meet a new scalar anew
------------------------------------------------------------------------- */

void FixFluidScalar::make_scalar()
{
  const bool continued = fluid_->partner()->add_scalar({.name = id, .diffusivity = script_.diffusivity(), .sides = script_.sides(), .initial = script_.initial(lmp)});
  followed_ = fluid_->whole_steps();
  if (continued) return;
  for (int i = 0; i < atom->nlocal; i++) std::fill_n(points()[i], static_cast<int>(N_COLUMNS), 0.0);
}

void FixFluidScalar::setup(int)
{
  if (objects_) meet_new_objects();
  array_atom = points();
}

/* ----------------------------------------------------------------------
   the scalar has made as many steps as the fluid
------------------------------------------------------------------------- */

void FixFluidScalar::end_of_step()
{
  array_atom = points();
  if (fluid_->whole_steps() == followed_) return;
  followed_ = fluid_->whole_steps();
  std::array<double, 6> side_values;
  const auto evaluate = [&] { side_values = script_.side_values(lmp); };
  if (script_.varies()) with_variables(lmp, update->ntimestep + 1, evaluate);
  else evaluate();
  const bool uptake = objects_ && script_.uptake() > 0.0;
  if (uptake) ask_for_uptake();
  try {
    scalar_->step(side_values, uptake ? &rates_ : nullptr, met_);
  } catch (const NotFinite &what_happened) {
    end_run(lmp, *this, what_happened.what());
  }
  if (objects_) take_in();
}

/* ----------------------------------------------------------------------
   objects that the scalar has not met: the cells at their ring points
------------------------------------------------------------------------- */

void FixFluidScalar::meet_new_objects()
{
  std::vector<const ObjectPoints *> fresh;
  std::vector<Triple> places;
  for (const ObjectPoints &object : objects_->objects()) {
    if (!objects_->owns(object) || points()[objects_->own_index(object.hub)][KNOWN] != 0.0) continue;
    fresh.push_back(&object);
    for (int k = 0; k < object.n_ring; k++) places.push_back({atom->x[object.ring[k]][0], atom->x[object.ring[k]][1], 0.0});
  }
  const std::vector<double> found = scalar_->values_at(places);
  sent_.assign(2 * (atom->nlocal + atom->nghost), 0.0);
  auto next = found.begin();
  for (const ObjectPoints *object : fresh) {
    double mean = 0.0;
    for (int k = 0; k < object->n_ring; k++) mean += *next++ / object->n_ring;
    meet(*object, mean);
    const int hub = objects_->own_index(object->hub);
    sent_[2 * hub] = 1.0;
    sent_[2 * hub + 1] = mean;
  }
  objects_->send_to_ghosts(sent_.data(), 2);
  for (const ObjectPoints &object : objects_->objects())
    for_each_point(object, [&](int i) {
      if (const int own = objects_->own_index(i); own >= 0 && sent_[2 * object.hub] != 0.0) points()[own][CONCENTRATION] = sent_[2 * object.hub + 1];
    });
}

void FixFluidScalar::meet(const ObjectPoints &object, double concentration)
{
  const std::vector<Vector2> outline = outline_of(lmp, object);
  double perimeter = 0.0;
  for (std::size_t k = 0; k < outline.size(); k++) perimeter += (outline[k] - outline[k > 0 ? k - 1 : outline.size() - 1]).norm();
  double *hub = points()[objects_->own_index(object.hub)];
  hub[KNOWN] = 1.0;
  hub[AREA] = outline_shape(outline).area;
  hub[AROUND] = concentration * perimeter;
}

/* ----------------------------------------------------------------------
   What an object has drunk in this step it is to take out of the water
   around it, at the rate (a length) that gives this with what was there in
   the last step; what it gets more or less now is put right in the next.
------------------------------------------------------------------------- */

bool FixFluidScalar::drinks(const ObjectPoints &object) const { return (atom->mask[object.hub] & groupbit) != 0; }

void FixFluidScalar::ask_for_uptake()
{
  rates_.assign(atom->nlocal + atom->nghost, 0.0);
  for (const ObjectPoints &object : objects_->objects())
    if (objects_->owns(object) && drinks(object)) thirst(object);
  objects_->send_to_ghosts(rates_.data(), 1);
  sent_ = rates_;
  for (const ObjectPoints &object : objects_->objects())
    for_each_point(object, [&](int i) {
      if (const int own = objects_->own_index(i); own >= 0) rates_[own] = sent_[object.hub];
    });
}

void FixFluidScalar::thirst(const ObjectPoints &object)
{
  const int own = objects_->own_index(object.hub);
  const double *point = objects_->points()[own], lambda = objects_->sizes()[own][FixObjects::LAMBDA];
  double *hub = points()[own];
  const double area = followed_area(hub[AREA], outline_shape(outline_of(lmp, object)).area, lambda * lambda * point[FixObjects::NATURAL_AREA]);
  hub[OWED] += script_.uptake() * (area - hub[AREA]);
  hub[AREA] = area;
  if (hub[OWED] > 0.0 && hub[AROUND] > 0.0) rates_[own] = std::min(hub[OWED] / hub[AROUND], largest_layer * fluid_->partner()->field_block().spacing);
}

/* ----------------------------------------------------------------------
   each rank with a point of an object sums up the same numbers in the same
   order
------------------------------------------------------------------------- */

void FixFluidScalar::take_in()
{
  const int n_own = atom->nlocal;
  sent_.assign(2 * (n_own + atom->nghost), 0.0);
  for (int i = 0; i < n_own; i++) {
    sent_[2 * i] = met_[i].amount;
    sent_[2 * i + 1] = met_[i].spacing;
  }
  objects_->send_to_ghosts(sent_.data(), 2);
  for (const ObjectPoints &object : objects_->objects()) {
    double amount = 0.0, spacing = 0.0;
    for (int k = 0; k < object.n_ring; k++) {
      amount += sent_[2 * object.ring[k]];
      spacing += sent_[2 * object.ring[k] + 1];
    }
    if (spacing == 0.0) continue;
    for_each_point(object, [&](int i) {
      if (const int own = objects_->own_index(i); own >= 0) points()[own][CONCENTRATION] = amount / spacing;
    });
    if (!objects_->owns(object)) continue;
    const int own = objects_->own_index(object.hub);
    double *hub = points()[own];
    const double taken = script_.uptake() > 0.0 ? rates_[own] * amount : 0.0;
    hub[UPTAKE] += taken;
    hub[OWED] -= taken;
    hub[AROUND] = amount;
  }
}

/* ---------------------------------------------------------------------- */

const double *FixFluidScalar::values()
{
  if (values_step_ == update->ntimestep || !scalar_) return values_;
  double sums[N_SUMS] = {};
  const bool current = objects_ && objects_->current_everywhere();
  for (std::size_t k = 0; current && k < objects_->objects().size(); k++) {
    const ObjectPoints &object = objects_->objects()[k];
    if (!objects_->owns(object) || !drinks(object)) continue;
    const double *hub = points()[objects_->own_index(object.hub)];
    sums[OBJECTS] += 1.0;
    sums[CONCENTRATIONS] += hub[CONCENTRATION];
    sums[STILL_OWED] += hub[OWED];
  }
  MPI_Allreduce(MPI_IN_PLACE, sums, N_SUMS, MPI_DOUBLE, MPI_SUM, world);
  const ScalarReport now = scalar_->report();
  const double all[N_VALUES] = {now.total, now.mean, now.smallest, now.largest, now.entered, now.left, now.withdrawn, now.balance_error,
                                sums[CONCENTRATIONS] / std::max(sums[OBJECTS], 1.0), sums[STILL_OWED], now.appeared, static_cast<double>(now.sub_steps)};
  std::copy(all, all + N_VALUES, values_);
  values_step_ = update->ntimestep;
  return values_;
}

double FixFluidScalar::compute_scalar() { return values()[1]; }

double FixFluidScalar::compute_vector(int n) { return values()[n]; }
