#include "object_measures.h"

#include <algorithm>

#include "atom.h"
#include "contact_forces.h"
#include "contact_partners.h"
#include "fix_fluid_scalar.h"
#include "fix_mass_spring.h"
#include "fix_objects.h"
#include "modify.h"
#include "object_geometry.h"
#include "objects/outline.h"
#include "objects/point_body.h"

using namespace LAMMPS_NS;
using swellflow::ObjectMeasures;
using swellflow::ObjectPoints;
using swellflow::Vector2;

namespace {

/// All that several objects share, taken once.
class Moment {
 public:
  Moment(LAMMPS *lmp, FixObjects &objects) : lmp_(lmp), atom_(*lmp->atom), objects_(objects), contacts_(lmp), partners_(lmp)
  {
    // Ghosts have the velocities of the middle of the step.
    velocity_.resize(2 * (atom_.nlocal + atom_.nghost));
    for (int i = 0; i < atom_.nlocal; i++)
      for (int d = 0; d < 2; d++) velocity_[2 * i + d] = atom_.v[i][d];
    objects.send_to_ghosts(velocity_.data(), 2);
    for (int k = 0; k < lmp->modify->nfix; k++) {
      const Fix *fix = lmp->modify->fix[k];
      if (const auto *one = dynamic_cast<const FixMassSpring *>(fix)) springs_.push_back(one);
      if (!scalar_) scalar_ = dynamic_cast<const FixFluidScalar *>(fix);
    }
  }

  ObjectMeasures measure(const ObjectPoints &object) const
  {
    ObjectMeasures measures;
    measures.id = atom_.molecule[object.hub];
    measure_motion(object, measures);
    measure_shape(object, measures);
    for (const FixMassSpring *springs : springs_)
      if (springs->acts_on(object)) measures.spring_energy += springs->energy_of(object);
    measure_contacts(object, measures);
    if (const int hub = objects_.own_index(object.hub); scalar_ && hub >= 0) {
      measures.concentration = scalar_->concentration(hub);
      measures.uptake = scalar_->uptake(hub);
    }
    return measures;
  }

 private:
  void measure_motion(const ObjectPoints &object, ObjectMeasures &measures) const
  {
    swellflow::PointBody body;
    for_each_point(object, [&](int i) {
      body.x.emplace_back(atom_.x[i][0] - atom_.x[object.hub][0], atom_.x[i][1] - atom_.x[object.hub][1]);
      body.v.emplace_back(velocity_[2 * i], velocity_[2 * i + 1]);
      body.mass.push_back(atom_.rmass[i]);
      measures.kinetic_energy += 0.5 * body.mass.back() * body.v.back().squaredNorm();
    });
    const swellflow::WholeMotion whole = swellflow::whole_motion(body);
    measures.mass = whole.mass;
    measures.velocity = {whole.velocity.x(), whole.velocity.y()};
    measures.spin = whole.spin();
    measures.rotation = objects_.points()[object.hub][FixObjects::ROTATION];
  }

  void measure_shape(const ObjectPoints &object, ObjectMeasures &measures) const
  {
    const double *hub = objects_.points()[object.hub];
    const double lambda = objects_.sizes()[object.hub][FixObjects::LAMBDA], natural_area = hub[FixObjects::NATURAL_AREA], diameter = hub[FixObjects::DIAMETER];
    const std::vector<Vector2> outline = outline_of(lmp_, object);
    const swellflow::OutlineShape shape = swellflow::outline_shape(outline);
    for (int d = 0; d < 2; d++) measures.centroid[d] = atom_.x[object.hub][d] + shape.centroid[d];
    for (const Vector2 &vertex : outline) measures.mean_diameter += 2.0 * vertex.norm() / object.n_ring;
    measures.diameter_of_area = swellflow::diameter_of_area(shape.area, natural_area, diameter);
    measures.natural_diameter = lambda * diameter;
    measures.swelling_ratio = lambda;
    measures.area = shape.area;
    measures.area_ratio = shape.area / (lambda * lambda * natural_area);
    measures.aspect_ratio = shape.aspect_ratio;
  }

  void measure_contacts(const ObjectPoints &object, ObjectMeasures &measures) const
  {
    for_each_point(object, [&](int i) {
      const Vector2 F = contacts_.on(i);
      measures.contact_force += F.norm();
      for (int d = 0; d < 2; d++) measures.net_contact_force[d] += F[d];
    });
    measures.contact_pressure = contacts_.pressure(object);
    measures.coordination = partners_.of(object);
  }

  LAMMPS *lmp_;
  const Atom &atom_;
  const FixObjects &objects_;
  ContactForces contacts_;
  ContactPartners partners_;
  std::vector<double> velocity_;  // two values an atom, own and ghosts
  std::vector<const FixMassSpring *> springs_;
  const FixFluidScalar *scalar_ = nullptr;
};

}  // namespace

std::vector<ObjectMeasures> LAMMPS_NS::measure_objects(LAMMPS *lmp, int groupbit)
{
  std::vector<ObjectMeasures> all;
  FixObjects *objects = find_objects(lmp);
  if (!objects || !objects->current_everywhere()) return all;
  objects->update_rotations();
  const Moment now(lmp, *objects);
  for (const ObjectPoints &object : objects->objects())
    if (objects->owns(object) && (lmp->atom->mask[object.hub] & groupbit)) all.push_back(now.measure(object));
  return all;
}
