// The copy out of LIGGGHTS' arrays, and sums over an object's points.
#include "coupling/output/object_shape.h"

#include <stdexcept>

#include "library.h"
#include "liggghts_plugins/fix_objects.h"

namespace swellflow {

namespace {

using Column = LAMMPS_NS::FixObjects;

template <typename Value>
Vec3 sum_over_points(const ObjectState &object, const Value &value)
{
  Vec3 sum = value(object.hub);
  for (const PointState &point : object.ring) {
    const Vec3 v = value(point);
    for (int d = 0; d < 3; ++d) sum[d] += v[d];
  }
  return sum;
}

/// LIGGGHTS' arrays for the length of one copy.
struct Arrays {
  double **x, *radius, *rmass, **object_point, **object_size;
  int *tag, *molecule;

  explicit Arrays(void *lammps)
      : x(static_cast<double **>(lammps_extract_atom(lammps, "x"))),
        radius(static_cast<double *>(lammps_extract_atom(lammps, "radius"))),
        rmass(static_cast<double *>(lammps_extract_atom(lammps, "rmass"))),
        object_point(static_cast<double **>(lammps_extract_fix(lammps, Column::PROPERTY, 1, 2, 0, 0))),
        object_size(static_cast<double **>(lammps_extract_fix(lammps, Column::SIZES, 1, 2, 0, 0))),
        tag(static_cast<int *>(lammps_extract_atom(lammps, "id"))),
        molecule(static_cast<int *>(lammps_extract_atom(lammps, "molecule")))
  {
    if (!x || !radius || !rmass || !tag || !molecule || !object_point || !object_size)
      throw std::runtime_error("objects need atom_style hybrid granular molecular and create_objects, but their per-atom data "
                               "are missing: issue create_objects before fix output/vtk");
  }
};

PointState point_state(const Arrays &arrays, const OutputFrame &frame, int i)
{
  PointState point;
  for (int d = 0; d < 3; ++d) {
    point.x[d] = arrays.x[i][d];
    point.velocity[d] = frame.velocity.at(3 * i + d);
    point.force[d] = frame.force.at(3 * i + d);
  }
  point.mass = arrays.rmass[i];
  const double *column = arrays.object_point[i];
  point.cds_radius = column[Column::HAS_CDS] != 0.0 ? arrays.radius[i] : 0.0;
  point.outline_offset = arrays.object_size[i][Column::LAMBDA] * column[Column::OUTLINE_OFFSET];
  point.tag = arrays.tag[i];
  return point;
}

}  // namespace

double ObjectState::mass() const
{
  return sum_over_points(*this, [](const PointState &p) { return Vec3{p.mass, 0.0, 0.0}; })[0];
}

Vec3 ObjectState::velocity() const
{
  Vec3 momentum = sum_over_points(*this, [](const PointState &p) {
    return Vec3{p.mass * p.velocity[0], p.mass * p.velocity[1], p.mass * p.velocity[2]};
  });
  const double m = mass();
  for (double &component : momentum) component /= m;
  return momentum;
}

Vec3 ObjectState::outer_force() const
{
  return sum_over_points(*this, [](const PointState &p) { return p.force; });
}

std::vector<Vector2> ObjectState::outline() const
{
  std::vector<Vector2> outline;
  outline.reserve(ring.size());
  for (const PointState &p : ring) outline.push_back(outline_point({p.x[0] - hub.x[0], p.x[1] - hub.x[1]}, p.outline_offset));
  return outline;
}

OutlineShape ObjectState::shape() const { return outline_shape(outline()); }

double ObjectState::mean_diameter() const
{
  double sum = 0.0;
  for (const Vector2 &vertex : outline()) sum += vertex.norm();
  return 2.0 * sum / static_cast<double>(ring.size());
}

std::vector<ObjectState> object_states(void *lammps, const OutputFrame &frame)
{
  std::vector<ObjectState> states;
  if (frame.objects.empty()) return states;
  const Arrays arrays(lammps);
  states.reserve(frame.objects.size());
  for (const ObjectPoints &object : frame.objects) {
    ObjectState state;
    const double *hub = arrays.object_point[object.hub];
    state.id = arrays.molecule[object.hub];
    state.swelling_ratio = arrays.object_size[object.hub][Column::LAMBDA];
    state.natural_diameter = hub[Column::DIAMETER] * state.swelling_ratio;
    state.hub = point_state(arrays, frame, object.hub);
    state.ring.reserve(object.n_ring);
    for (int k = 0; k < object.n_ring; ++k) state.ring.push_back(point_state(arrays, frame, object.ring[k]));
    states.push_back(std::move(state));
  }
  return states;
}

}  // namespace swellflow
