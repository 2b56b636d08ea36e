// What the guard and the accuracy budget ask of the fluid.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "atom.h"
#include "fix_fluid_ib.h"
#include "fix_objects.h"
#include "fix_rigid_cds.h"
#include "guard.h"
#include "integrators.h"
#include "modify.h"
#include "object_geometry.h"
#include "options.h"
#include "update.h"
#include "worst_object.h"

using namespace LAMMPS_NS;
using namespace swellflow;
using namespace std::string_literals;

double FixFluidIb::cell() const { return (box_high_[0] - box_low_[0]) / script_->options().cells[0]; }

/* ----------------------------------------------------------------------
   before the first step
------------------------------------------------------------------------- */

void FixFluidIb::add_limits(std::vector<Figure> &figures)
{
  if (script_->options().advection != AdvectionScheme::none) add_cfl_limit(figures);
  if (!find_objects(lmp)) return;
  if ((has_free_objects_ = moves_objects())) figures.push_back(viscous_figure(chooses_steps() ? 1 : dem_steps_per_step()));
  has_only_rigid_objects_ = has_free_objects_ && moves_only_rigid_objects();
  add_limits_of_objects(figures);
}

/// With 'cfl' the first fluid step has one DEM step, and later ones as many as the flow allows, but one at least.
void FixFluidIb::add_cfl_limit(std::vector<Figure> &figures)
{
  const int dem_steps = chooses_steps() ? 1 : dem_steps_per_step();
  double speed = partner_->largest_speed();
  std::string where = "the flow as it is";
  const FluidDrive now = drive();
  for (const Triple &side : now.side_velocity)
    if (const double of_side = std::abs(side[0]) + std::abs(side[1]); of_side > speed) speed = of_side, where = "a side of the box";
  figures.push_back(cfl_figure(speed * dem_steps * update->dt / cell(), where));
}

/// From the first on flows past objects may blow up; beyond the poor one they have, and those without objects are right only where they do not change.
Figure FixFluidIb::cfl_figure(double value, const std::string &where) const
{
  const double poor = find_objects(lmp) ? 10.0 : 50.0;
  return {.name = "CFL number", .value = value, .watch = 0.7, .poor = poor, .place = where + ", fix " + id,
          .remedy = "use a shorter 'timestep', a smaller 'every', 'cfl 0.5', or fewer 'cells'"};
}

/// Collective.
bool FixFluidIb::moves_objects() const
{
  const FixObjects &known = *find_objects(lmp);
  int some = 0;
  for (int k = 0; k < modify->nfix; k++) {
    const Fix &fix = *modify->fix[k];
    if (!solves_springs(fix) && !takes_springs_as_forces(fix)) continue;
    for (int i = 0; i < atom->nlocal && !some; i++) some = known.is_point(i) && (atom->mask[i] & fix.groupbit);
  }
  MPI_Allreduce(MPI_IN_PLACE, &some, 1, MPI_INT, MPI_MAX, world);
  return some;
}

/// Those that springs hold together vibrate, and the fluid meets the mean over its step.
bool FixFluidIb::moves_only_rigid_objects() const
{
  const FixObjects &known = *find_objects(lmp);
  int soft = 0;
  for (int k = 0; k < modify->nfix; k++) {
    const Fix &fix = *modify->fix[k];
    if (dynamic_cast<const FixRigidCds *>(&fix) || (!solves_springs(fix) && !takes_springs_as_forces(fix))) continue;
    for (int i = 0; i < atom->nlocal && !soft; i++) soft = known.is_point(i) && (atom->mask[i] & fix.groupbit);
  }
  MPI_Allreduce(MPI_IN_PLACE, &soft, 1, MPI_INT, MPI_MAX, world);
  return !soft;
}

/// Crank and Nicolson's step lets what is as fine as cells swing on from step to step, the more so the larger this is, and free objects feed it by the force that comes a step late.
Figure FixFluidIb::viscous_figure(int dem_steps) const
{
  return {.name = "viscosity times fluid step over the square of a cell, with objects that move,", .value = kinematic_viscosity() * dem_steps * update->dt / (cell() * cell()), .watch = 50.0,
          .poor = 100.0, .place = "fix "s + id, .remedy = "use a shorter 'timestep', a smaller 'every', or fewer 'cells'"};
}

void FixFluidIb::add_limits_of_objects(std::vector<Figure> &figures)
{
  enum { LIGHT, HEAVY, SMALL, SPARSE, N_LIMITS };
  std::array<WorstObject, N_LIMITS> worst;
  const FixObjects &known = *find_objects(lmp);
  for (const ObjectPoints &object : known.objects()) {
    if (!known.owns(object)) continue;
    const double *point = known.points()[object.hub], *size = known.sizes()[object.hub], lambda = size[FixObjects::LAMBDA];
    const double density = point[FixObjects::OBJECT_MASS] * atom->rmass[object.hub] / size[FixObjects::MASS] / (lambda * lambda * point[FixObjects::NATURAL_AREA]);
    const double values[] = {this->density() / density, density / this->density(), cell() / (lambda * point[FixObjects::DIAMETER]), largest_marker_gap(object)};
    for (int k = 0; k < N_LIMITS; k++) worst[k].meet(values[k], atom->molecule[object.hub]);
  }
  agree_on_worst(world, worst);
  const auto add = [&](int k, const char *name, double watch, double poor, const char *remedy) {
    if (worst[k].object > 0) figures.push_back({.name = name, .value = worst[k].value, .watch = watch, .poor = poor, .place = name_of(worst[k].object), .remedy = remedy});
  };
  add(LIGHT, "density of the fluid over that of an object", 1010.0, Figure::never, "make the object heavier");
  add(HEAVY, "density of an object over that of the fluid", 1010.0, Figure::never, "make the object lighter, or leave the fluid out");
  add(SMALL, "cell over the diameter of an object", 0.25, 1.0, "use more 'cells', or larger objects");
  add(SPARSE, "distance of neighbouring markers in cells", 2.0, Figure::never, "use a smaller 'marker_gap', or more 'points'");
}

/// Of those of this rank's images; each ring point has as many as keep their natural distance within marker_gap.
double FixFluidIb::largest_marker_gap(const ObjectPoints &object) const
{
  const FixObjects &known = *find_objects(lmp);
  const std::vector<Vector2> outline = outline_of(lmp, object);
  double natural = 0.0, actual = 0.0;
  for (std::size_t k = 0; k < outline.size(); k++) {
    const int i = object.ring[k];
    natural = std::max(natural, known.sizes()[i][FixObjects::LAMBDA] * known.points()[i][FixObjects::RING_LENGTH]);
    actual = std::max(actual, (outline[k] - outline[k > 0 ? k - 1 : outline.size() - 1]).norm());
  }
  const double per_point = std::max(1.0, std::ceil(natural / (script_->options().marker_gap * cell()) - 1e-9));
  return actual / per_point / cell();
}

/* ----------------------------------------------------------------------
   since the run began
------------------------------------------------------------------------- */

/// Collective.
double FixFluidIb::largest_speed_of_points() const
{
  const FixObjects *known = find_objects(lmp);
  double square = 0.0;
  for (int i = 0; known && i < atom->nlocal; i++)
    if (known->is_point(i)) square = std::max(square, Vector2(atom->v[i][0], atom->v[i][1]).squaredNorm());
  MPI_Allreduce(MPI_IN_PLACE, &square, 1, MPI_DOUBLE, MPI_MAX, world);
  return std::sqrt(square);
}

void FixFluidIb::note_accuracy()
{
  constexpr int steps_between_reports = 20;
  constexpr long many_steps = 200;
  slip_.add(partner_->mean_slip());
  if (whole_steps_ % steps_between_reports != 0) return;
  worst_.add(report(), cell(), largest_speed_of_points());
  if (const Figure now = cfl_figure(report().cfl, "the flow as it is"); now.is_poor() && script_->options().advection != AdvectionScheme::none) judge(lmp, now);
  if (const Figure now = viscous_figure(dem_steps_); now.is_poor() && has_free_objects_) judge(lmp, now);
  judge_slip(many_steps);
}

/// What bounces about faster than the fluid can follow is not right however small the momentum that gets lost. `least`: number of such steps from which on it counts.
void FixFluidIb::judge_slip(long least)
{
  slip_.settle(worst_.speed());
  // What rests trembles by round-off or by its contacts, and slips as much as it moves.
  constexpr double trembling = 0.1;  // cells in a fluid step
  if (worst_.speed() * dt_ * dem_steps_ < trembling * cell()) return;
  if (!has_only_rigid_objects_ || slip_.beyond() < least) return;
  const Figure now{.name = "share of fluid steps in which the slip at the outlines of rigid objects is beyond " + rounded(SlipLook::bound) + " of the largest speed", .value = slip_.share(),
                   .watch = 0.5, .poor = 0.5, .place = "fix "s + id, .remedy = "use a shorter 'timestep', a smaller 'every', stiffer contacts, or contacts with damping"};
  if (now.is_poor()) judge(lmp, now);
}

void FixFluidIb::add_accuracy(std::vector<Figure> &figures)
{
  if (!partner_ || whole_steps_ == 0) return;
  worst_.add(report(), cell(), largest_speed_of_points());
  const std::string place = "fix "s + id;
  figures.push_back({.name = "CFL number", .value = worst_.cfl, .watch = 0.7, .poor = 1.3, .place = place, .remedy = "use a shorter 'timestep', a smaller 'every', or 'cfl 0.5'"});
  figures.push_back({.name = "divergence, cells x divergence / speed", .value = worst_.divergence(), .watch = 1e-9, .poor = 1e-6, .place = place, .remedy = "use a shorter 'timestep'"});
  if (!find_objects(lmp)) return;
  figures.push_back({.name = "slip at outlines / speed", .value = worst_.slip(), .watch = 0.01, .poor = 0.05, .place = place,
                     .remedy = "use a shorter 'timestep', a smaller 'every'"s + (script_->options().projections < 2 ? ", 'projections 2'" : "") + " or 'forcing multi 3'"});
  figures.push_back({.name = "momentum given less received / exchanged", .value = worst_.momentum_error, .watch = 1e-9, .poor = 1e-6, .place = place, .remedy = "use a shorter 'timestep'"});
  figures.push_back({.name = "distance of markers / cell", .value = worst_.marker_gap, .watch = 1.5, .poor = 2.0, .place = place, .remedy = "use a smaller 'marker_gap', or more 'points'"});
}
