#include "coupling/marker_ring.h"

#include <algorithm>
#include <cmath>

#include "liggghts_plugins/fix_objects.h"
#include "liggghts_plugins/objects/outline.h"

namespace swellflow {

using Column = LAMMPS_NS::FixObjects::Column;

/// outline_point() is from_hub * (1 + excess).
double MarkerRing::excess(const ObjectPoints &object, const DemEngine &points, int ring_point)
{
  const int i = object.ring[ring_point];
  const double offset = points.object_point[i][Column::LAMBDA] * points.object_point[i][Column::OUTLINE_OFFSET];
  if (offset == 0.0) return 0.0;
  const double distance = std::hypot(points.x[i][0] - points.x[object.hub][0], points.x[i][1] - points.x[object.hub][1]);
  return distance > 0.0 ? offset / distance : 0.0;
}

/// A marker's place on the side of the outline between the vertices of two points is a sum of shares of point, partner and hub; so is its place after retraction.
void MarkerRing::place(const ObjectPoints &object, const DemEngine &points, int per_point, double retraction)
{
  per_point_ = per_point;
  inner_start_.clear();
  markers_.resize(static_cast<std::size_t>(object.n_ring) * per_point);
  from_hub_.resize(markers_.size());
  outline_.resize(markers_.size());
  const double *x_hub = points.x[object.hub], *u_hub = points.v[object.hub];
  if (points.object_point[object.hub][Column::SPOKES] == 0.0) retraction = 0.0;
  for (int m = 0; m < size(); ++m) {
    Marker &marker = markers_[m];
    marker.point = m / per_point;
    const double t = (m % per_point + 0.5) / per_point - 0.5;
    marker.partner = (marker.point + (t < 0.0 ? object.n_ring - 1 : 1)) % object.n_ring;
    const double along = std::abs(t);
    const int i = object.ring[marker.point], j = object.ring[marker.partner];
    const double excess_i = (1.0 - along) * excess(object, points, marker.point), excess_j = along * excess(object, points, marker.partner);
    const double whole = 1.0 + (excess_i + excess_j);
    for (int d = 0; d < 2; ++d)
      outline_[m][d] = (1.0 - along + excess_i) * points.x[i][d] + (along + excess_j) * points.x[j][d] - whole * x_hub[d];
    const double distance = outline_[m].norm(), pull = distance > 0.0 ? std::min(0.5, retraction / distance) : 0.0;
    marker.along = (along + excess_j) / whole;
    marker.share = pull - (1.0 - pull) * (excess_i + excess_j);
    for (int d = 0; d < 2; ++d) {
      from_hub_[m][d] = (1.0 - pull) * outline_[m][d];
      marker.x[d] = x_hub[d] + from_hub_[m][d];
      marker.u[d] = marker.point_weight() * points.v[i][d] + marker.partner_weight() * points.v[j][d] + marker.share * u_hub[d];
    }
  }
  const OutlineShape shape = outline_shape(from_hub_);
  area_ = shape.area;
  outline_area_ = outline_shape(outline_).area;
  centroid_ = {x_hub[0] + shape.centroid.x(), x_hub[1] + shape.centroid.y()};
}

double MarkerRing::gap(int m) const
{
  const Vec<2> &a = markers_[m].x, &b = markers_[after(m)].x;
  return std::hypot(b[0] - a[0], b[1] - a[1]);
}

double MarkerRing::perimeter() const
{
  double sum = 0.0;
  for (int m = 0; m < size(); ++m) sum += gap(m);
  return sum;
}

double MarkerRing::dilation_rate() const
{
  if (area_ <= 0.0) return 0.0;
  double flux = 0.0;
  for (int m = 0; m < size(); ++m) {
    const Vec<2> &a = markers_[before(m)].x, &b = markers_[after(m)].x, &u = markers_[m].u;
    flux += 0.5 * ((b[1] - a[1]) * u[0] - (b[0] - a[0]) * u[1]);
  }
  return flux / (2.0 * area_);
}

}  // namespace swellflow
