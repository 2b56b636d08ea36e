#include "contact_limits.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>

#include "atom.h"
#include "fix_fluid_ib.h"
#include "fix_objects.h"
#include "fix_property_global.h"
#include "fix_rigid_cds.h"
#include "force.h"
#include "integrators.h"
#include "modify.h"
#include "neigh_list.h"
#include "pair.h"
#include "update.h"

using namespace LAMMPS_NS;
using swellflow::Figure;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// What takes part in contacts, by atom type. A wall is what nothing moves.
struct Partners {
  explicit Partners(int types) : mass(types + 1, infinity), radius(types + 1, infinity), there(types + 1, 0), walls(types + 1, 0) {}
  std::vector<double> mass;    ///< the smallest that contacts move
  std::vector<double> radius;  ///< the smallest
  std::vector<int> there;      ///< atoms
  std::vector<int> walls;
  double parties = 0.0;        ///< objects, and atoms that are no points
};

class PartnerSearch {
 public:
  explicit PartnerSearch(LAMMPS *lmp) : lmp_(lmp), atom_(*lmp->atom), objects_(find_objects(lmp)), fluid_(find_fluid(lmp)) {}

  /// Collective.
  Partners find() const
  {
    Partners found(atom_.ntypes);
    for (int i = 0; i < atom_.nlocal; i++) add(i, found);
    const int n = atom_.ntypes + 1;
    MPI_Allreduce(MPI_IN_PLACE, found.mass.data(), n, MPI_DOUBLE, MPI_MIN, lmp_->world);
    MPI_Allreduce(MPI_IN_PLACE, found.radius.data(), n, MPI_DOUBLE, MPI_MIN, lmp_->world);
    MPI_Allreduce(MPI_IN_PLACE, found.there.data(), n, MPI_INT, MPI_MAX, lmp_->world);
    MPI_Allreduce(MPI_IN_PLACE, &found.parties, 1, MPI_DOUBLE, MPI_SUM, lmp_->world);
    for (int k = 0; k < lmp_->modify->nfix; k++) {
      Fix &fix = *lmp_->modify->fix[k];
      const bool is_wall = strncmp(fix.style, "wall/gran", 9) == 0 || strncmp(fix.style, "mesh/", 5) == 0;
      if (const int type = is_wall ? fix.max_type() : 0; type > 0 && type < n) found.walls[type] = 1;
    }
    return found;
  }

 private:
  void add(int i, Partners &found) const
  {
    const double *point = objects_ && objects_->is_point(i) ? objects_->points()[i] : nullptr;
    if (!point || point[FixObjects::INDEX] < 0.0) found.parties += 1.0;
    if (point && point[FixObjects::HAS_CDS] == 0.0) return;
    const int type = atom_.type[i];
    found.there[type] = 1;
    found.radius[type] = std::min(found.radius[type], atom_.radius[i]);
    found.mass[type] = std::min(found.mass[type], moved_mass(i, point));
  }

  /// A point is pushed alone, also where springs are solved implicitly: these do not know of contacts. A rigid object moves as a whole, but several contacts at once push it.
  double moved_mass(int i, const double *point) const
  {
    constexpr double contacts_of_an_object = 10.0;
    for (int k = 0; k < lmp_->modify->nfix; k++) {
      const Fix &fix = *lmp_->modify->fix[k];
      if (!(atom_.mask[i] & fix.groupbit)) continue;
      if (point && dynamic_cast<const FixRigidCds *>(&fix)) return whole_mass(point, i) / contacts_of_an_object;
      if (solves_springs(fix) || takes_springs_as_forces(fix)) return atom_.rmass[i] + (point ? share_of_fluid(point, i) : 0.0);
    }
    return infinity;
  }
  double whole_mass(const double *point, int i) const { return point[FixObjects::OBJECT_MASS] * atom_.rmass[i] / objects_->sizes()[i][FixObjects::MASS]; }

  /// Half of kappa times the DEM step: drag that is taken implicitly, as it is in (1 - K dt^2/4) m > -kappa dt/2, counts as so much mass. For the kernels' usual scale, 1/2.
  double share_of_fluid(const double *point, int i) const
  {
    if (!fluid_ || point[FixObjects::INDEX] < 0.0) return 0.0;
    return fluid_->density() * objects_->sizes()[i][FixObjects::LAMBDA] * point[FixObjects::RING_LENGTH] * fluid_->cell() / fluid_->dem_steps_per_step();
  }

  LAMMPS *lmp_;
  const Atom &atom_;
  const FixObjects *objects_;
  const FixFluidIb *fluid_;
};

double reduced(double a, double b) { return a == infinity ? b : b == infinity ? a : a * b / (a + b); }

/// Force per overlap of two partners. LIGGGHTS does not tell its contact model; each has property/global fixes of its own.
class Stiffness {
 public:
  explicit Stiffness(LAMMPS *lmp) : lmp_(lmp) {}

  double operator()(int a, int b, double radius, double mass) const
  {
    if (auto *kn = property("kn", "peratomtypepair")) return kn->compute_array(a - 1, b - 1);  // hooke/stiffness
    const double Y = modulus(a, b);
    if (Y == 0.0 || radius == infinity) return 0.0;
    auto *speed = property("characteristicVelocity", "scalar");
    // hertz: F = 4/3 Y sqrt(R) d^1.5, whose slope at an overlap of a tenth of the radius is
    if (!speed) return 2.0 * Y * radius * std::sqrt(0.1);
    // hooke, as LIGGGHTS has it: the linear contact with the overlap that Hertz' has at this speed
    const double v = speed->compute_scalar();
    return 16.0 / 15.0 * std::sqrt(radius) * Y * std::pow(15.0 * mass * v * v / (16.0 * std::sqrt(radius) * Y), 0.2);
  }

 private:
  FixPropertyGlobal *property(const char *name, const char *kind) const
  {
    const int n = lmp_->atom->ntypes;
    const bool pairs = strcmp(kind, "peratomtypepair") == 0, scalar = strcmp(kind, "scalar") == 0;
    return dynamic_cast<FixPropertyGlobal *>(lmp_->modify->find_fix_property(name, "property/global", kind, scalar ? 0 : n, pairs ? n : 0, "guard", false));
  }
  /// 1/Y = (1 - nu_a^2)/Y_a + (1 - nu_b^2)/Y_b
  double modulus(int a, int b) const
  {
    auto *Y = property("youngsModulus", "peratomtype"), *nu = property("poissonsRatio", "peratomtype");
    if (!Y || !nu) return 0.0;
    const auto softness = [&](int type) { return (1.0 - std::pow(nu->compute_vector(type - 1), 2)) / Y->compute_vector(type - 1); };
    return 1.0 / (softness(a) + softness(b));
  }

  LAMMPS *lmp_;
};

}  // namespace

/* ----------------------------------------------------------------------
   Two masses on a spring k are stable, with velocity Verlet, up to
   dt = 2 sqrt(m/k), m the reduced mass: 2/pi times the time of a collision
------------------------------------------------------------------------- */

void LAMMPS_NS::add_contact_step(LAMMPS *lmp, std::vector<Figure> &figures, double watch, double poor)
{
  if (!lmp->force->pair_match("gran", 0)) return;
  const Partners found = PartnerSearch(lmp).find();
  const Stiffness stiffness(lmp);
  double worst = 0.0;
  std::string place;
  const auto meet = [&](int a, int b, double mass, double radius, const char *whom) {
    if (mass == infinity) return;
    const double k = stiffness(a, b, radius, mass), over = 0.5 * lmp->update->dt * std::sqrt(k / mass);
    if (over <= worst) return;
    worst = over;
    place = "contacts of atoms of type " + std::to_string(a) + whom + std::to_string(b);
  };
  for (int a = 1; a <= lmp->atom->ntypes; a++)
    for (int b = 1; b <= lmp->atom->ntypes && found.there[a]; b++) {
      const double radius = found.radius[a] * found.radius[b] / (found.radius[a] + found.radius[b]);
      if (b >= a && found.there[b] && found.parties > 1.0) meet(a, b, reduced(found.mass[a], found.mass[b]), radius, " with those of type ");
      if (found.walls[b]) meet(a, b, found.mass[a], found.radius[a], " with walls of type ");
    }
  if (worst == 0.0) return;
  figures.push_back({.name = "time step over the longest with which contacts are stable", .value = worst, .watch = watch, .poor = poor, .place = place,
                     .remedy = "shorten 'timestep' or make contacts softer, by the square of that ratio"});
}

/* ---------------------------------------------------------------------- */

namespace {

struct Deepest { double overlap; int tag; };  // laid out as MPI_DOUBLE_INT

void deepen(Deepest &deepest, double overlap, int tag)
{
  if (overlap > deepest.overlap) deepest = {overlap, tag};
}

void look_at_pairs(LAMMPS *lmp, Deepest &deepest)
{
  const Atom *atom = lmp->atom;
  const NeighList *list = lmp->force->pair->list;
  for (int n = 0; list && n < list->inum; n++) {
    const int i = list->ilist[n];
    for (int k = 0; k < list->numneigh[i]; k++) {
      const int j = list->firstneigh[i][k] & NEIGHMASK;
      double square = 0.0;
      for (int d = 0; d < 3; d++) square += (atom->x[i][d] - atom->x[j][d]) * (atom->x[i][d] - atom->x[j][d]);
      const double reach = atom->radius[i] + atom->radius[j];
      if (square < reach * reach) deepen(deepest, (reach - std::sqrt(square)) / std::min(atom->radius[i], atom->radius[j]), atom->tag[i]);
    }
  }
}

}  // namespace

void LAMMPS_NS::add_overlap(LAMMPS *lmp, std::vector<Figure> &figures)
{
  if (!lmp->force->pair_match("gran", 0)) return;
  const FixObjects *objects = find_objects(lmp);
  if (objects && !objects->current_everywhere()) return;
  Deepest deepest{0.0, 0};
  look_at_pairs(lmp, deepest);
  MPI_Allreduce(MPI_IN_PLACE, &deepest, 1, MPI_DOUBLE_INT, MPI_MAXLOC, lmp->world);
  if (deepest.tag == 0) return;
  figures.push_back({.name = "deepest overlap over the sphere's radius", .value = deepest.overlap, .watch = 0.1, .poor = 0.5, .place = "the contact of atom " + std::to_string(deepest.tag),
                     .remedy = "make contacts stiffer"});
}
