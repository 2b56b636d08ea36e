#include "fix_nve_cds_implicit.h"

#include <algorithm>
#include <cstring>

#include "atom.h"
#include "comm.h"
#include "error.h"
#include "fix_mass_spring.h"
#include "fix_nve_cds.h"
#include "fix_objects.h"
#include "modify.h"
#include "options.h"
#include "update.h"

using namespace LAMMPS_NS;
using swellflow::ObjectPoints;

namespace {

swellflow::SpringEnergy energy_given(LAMMPS *lmp, const std::string &place, int narg, char **arg, const std::function<void(swellflow::Options &)> &others)
{
  int energy = 0;
  swellflow::or_stop(lmp, [&] {
    swellflow::Arguments line(place, narg, arg);
    swellflow::Options options(place);
    options.choice("energy", energy, {"dissipate", "conserve"}, "what becomes of vibrations that are faster than the step");
    others(options);
    options.parse(line);
  });
  return energy == 0 ? swellflow::SpringEnergy::dissipate : swellflow::SpringEnergy::conserve;
}

}  // namespace

Fix *LAMMPS_NS::create_nve_cds(LAMMPS *lmp, int narg, char **arg)
{
  if (narg > 3 && strcmp(arg[3], "implicit") == 0) return new FixNveCdsImplicit(lmp, narg, arg);
  return new FixNveCds(lmp, narg, arg);
}

FixNveCdsImplicit::FixNveCdsImplicit(LAMMPS *lmp, int narg, char **arg) :
    FixObjectIntegrator(lmp, narg, arg),
    solver_(energy_given(lmp, std::string("fix ") + id + " nve/cds implicit", narg - 4, arg + 4, [this](swellflow::Options &options) { declare_spin(options); })),
    moved_objects_(0), iterations_before_(0), failed_object_(0)
{
  // Backward Euler must see what squeezes an object together with what resists, or points in contact would not rest; the discrete gradient conserves energy
  // only with half a step of both before and after it.
  if (solver_.energy() == swellflow::SpringEnergy::conserve) set_outer_forces(OuterForces::point_by_point);
  scalar_flag = 1;
  global_freq = 1;
  extscalar = 0;
}

/* ---------------------------------------------------------------------- */

void FixNveCdsImplicit::init()
{
  FixObjectIntegrator::init();
  springs_.clear();
  for (int k = 0; k < modify->nfix; k++)
    if (const auto *springs = dynamic_cast<const FixMassSpring *>(modify->fix[k])) springs_.push_back(springs);
}

void FixNveCdsImplicit::setup(int vflag)
{
  FixObjectIntegrator::setup(vflag);
  require_springs();
}

const FixMassSpring *FixNveCdsImplicit::springs_of(const ObjectPoints &object) const
{
  for (const FixMassSpring *springs : springs_)
    if (springs->acts_on(object)) return springs;
  return nullptr;
}

void FixNveCdsImplicit::require_springs() const
{
  int wrong[2] = {0, 0};  // objects with none, with several
  for (const ObjectPoints &object : objects()->objects()) {
    if (!(atom->mask[object.hub] & groupbit)) continue;
    const auto number = std::count_if(springs_.begin(), springs_.end(), [&](const FixMassSpring *springs) { return springs->acts_on(object); });
    if (number != 1) wrong[number > 1] = std::max(wrong[number > 1], atom->molecule[object.hub]);
  }
  MPI_Allreduce(MPI_IN_PLACE, wrong, 2, MPI_INT, MPI_MAX, world);
  if (wrong[0] || wrong[1])
    error->fix_error(FLERR, const_cast<FixNveCdsImplicit *>(this),
                     ("an object that is moved implicitly must have one fix mass_spring, but object (molecule) " + std::to_string(std::max(wrong[0], wrong[1])) +
                      (wrong[0] ? " has none: add one, or use fix rigid/cds" : " has several: unfix all but one")).c_str());
}

/* ---------------------------------------------------------------------- */

void FixNveCdsImplicit::initial_integrate(int vflag)
{
  moved_objects_ = 0;
  iterations_before_ = solver_.newton_iterations();
  FixObjectIntegrator::initial_integrate(vflag);
  require_convergence();
}

void FixNveCdsImplicit::move(const ObjectPoints &object, swellflow::PointBody &body, const std::vector<swellflow::Vector2> &excess)
{
  moved_objects_++;
  if (!solver_.advance(body, springs_of(object)->springs_of(object), excess, update->dt)) failed_object_ = atom->molecule[object.hub];
}

void FixNveCdsImplicit::require_convergence()
{
  if (comm->nprocs > 1) MPI_Allreduce(MPI_IN_PLACE, &failed_object_, 1, MPI_INT, MPI_MAX, world);
  if (!failed_object_) return;
  error->fix_error(FLERR, this, ("the motion of an object must follow from its springs and forces, but no solution was found for object (molecule) " +
                                 std::to_string(failed_object_) + " at step " + std::to_string(update->ntimestep) +
                                 ": use a shorter time step, softer contacts, or slower swelling").c_str());
}

/// Newton iterations an object in the last step.
double FixNveCdsImplicit::compute_scalar()
{
  double sums[2] = {static_cast<double>(solver_.newton_iterations() - iterations_before_), static_cast<double>(moved_objects_)};
  MPI_Allreduce(MPI_IN_PLACE, sums, 2, MPI_DOUBLE, MPI_SUM, world);
  return sums[1] > 0.0 ? sums[0] / sums[1] : 0.0;
}
