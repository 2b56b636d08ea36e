#include "contact_forces.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "atom.h"
#include "error.h"
#include "fix.h"
#include "fix_lubrication_cds.h"
#include "fix_mass_spring.h"
#include "fix_objects.h"
#include "force.h"
#include "gravity.h"
#include "modify.h"
#include "object_geometry.h"
#include "objects/outline.h"

using namespace LAMMPS_NS;
using swellflow::Vector2;

namespace {

/// Of a sum of a few forces, over their magnitudes: what is left below it when the known ones are taken away is nothing.
constexpr double round_off = 1e-14;

}  // namespace

ContactForces::ContactForces(LAMMPS *lmp) : lmp_(lmp)
{
  FixObjects *objects = find_objects(lmp);
  if (!objects || !lmp->force->pair) return;
  const Atom *atom = lmp->atom;
  std::vector<double> given(2 * atom->nlocal, 0.0);
  for (int k = 0; k < lmp->modify->nfix; k++) {
    if (const auto *springs = dynamic_cast<FixMassSpring *>(lmp->modify->fix[k])) springs->add_given(given.data());
    if (const auto *lubrication = dynamic_cast<FixLubricationCds *>(lmp->modify->fix[k])) lubrication->add_given(given.data());
  }
  const std::vector<double> weight = weights();
  forces_.assign(2 * (atom->nlocal + atom->nghost), 0.0);
  for (int k = 0; k < 2 * atom->nlocal; k++) {
    const double whole = atom->f[k / 2][k % 2], left = whole - given[k] - weight[k];
    if (std::abs(left) > round_off * std::max({std::abs(whole), std::abs(given[k]), std::abs(weight[k])})) forces_[k] = left;
  }
  objects->send_to_ghosts(forces_.data(), 2);
}

std::vector<double> ContactForces::weights() const
{
  const Atom *atom = lmp_->atom;
  std::vector<double> weight(2 * atom->nlocal, 0.0);
  for (const Gravity &gravity : gravities(lmp_))
    for (int i = 0; i < atom->nlocal; i++)
      if (atom->mask[i] & gravity.groupbit)
        for (int d = 0; d < 2; d++) weight[2 * i + d] += atom->rmass[i] * gravity.acceleration[d];
  return weight;
}

Vector2 ContactForces::on(int i) const
{
  if (forces_.empty()) return Vector2::Zero();
  return {forces_[2 * i], forces_[2 * i + 1]};
}

double ContactForces::pressure(const swellflow::ObjectPoints &object) const
{
  if (forces_.empty()) return 0.0;
  const Atom *atom = lmp_->atom;
  const Vector2 hub(atom->x[object.hub][0], atom->x[object.hub][1]);
  double mass = 0.0, virial = 0.0;
  Vector2 centre = Vector2::Zero(), force = Vector2::Zero();
  for_each_point(object, [&](int i) {
    const Vector2 r = Vector2(atom->x[i][0], atom->x[i][1]) - hub;
    mass += atom->rmass[i];
    centre += atom->rmass[i] * r;
    force += on(i);
    virial += on(i).dot(r);
  });
  const double area = swellflow::outline_shape(outline_of(lmp_, object)).area;
  return area == 0.0 ? 0.0 : (force.dot(centre / mass) - virial) / (2.0 * std::abs(area));
}

void LAMMPS_NS::require_whole_forces(LAMMPS *lmp, const Fix &asking)
{
  const Modify *modify = lmp->modify;
  for (int k = modify->nfix - 1; k >= 0 && modify->fix[k] != &asking; k--)
    if (modify->fmask[k] & FixConst::POST_FORCE)
      lmp->error->fix_error(FLERR, const_cast<Fix *>(&asking),
                            (std::string("contact forces are measured when all forces have been summed up, but fix ") + modify->fix[k]->id + " (" +
                             modify->fix[k]->style + "), which may change them, comes later: put it above this one").c_str());
}
