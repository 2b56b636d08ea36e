#include "contact_forces.h"

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
  forces_.assign(2 * (atom->nlocal + atom->nghost), 0.0);
  for (int i = 0; i < atom->nlocal; i++)
    for (int d = 0; d < 2; d++) forces_[2 * i + d] = atom->f[i][d] - given[2 * i + d];
  take_away_weight();
  objects->send_to_ghosts(forces_.data(), 2);
}

void ContactForces::take_away_weight()
{
  const Atom *atom = lmp_->atom;
  for (const Gravity &gravity : gravities(lmp_))
    for (int i = 0; i < atom->nlocal; i++)
      if (atom->mask[i] & gravity.groupbit)
        for (int d = 0; d < 2; d++) forces_[2 * i + d] -= atom->rmass[i] * gravity.acceleration[d];
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
