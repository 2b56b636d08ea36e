#include "coupling/marker_ring.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "liggghts_plugins/fix_objects.h"
#include "liggghts_plugins/objects/outline.h"

namespace swellflow {

using Column = LAMMPS_NS::FixObjects;

void MarkerRing::look_at_vertices(const ObjectPoints &object, const DemEngine &points)
{
  vertices_.resize(object.n_ring);
  const double *x_hub = points.x[object.hub], lambda = points.object_size[object.hub][Column::LAMBDA];
  for (int k = 0; k < object.n_ring; ++k) {
    const int i = object.ring[k];
    const double *x = points.x[i], *v = points.v[i], offset = lambda * points.object_point[i][Column::OUTLINE_OFFSET];
    const Vector2 from_hub(x[0] - x_hub[0], x[1] - x_hub[1]);
    const double distance = offset == 0.0 ? 0.0 : from_hub.norm();
    vertices_[k] = {from_hub, Vector2(v[0], v[1]), distance > 0.0 ? offset / distance : 0.0};
  }
}

/// A marker's place on the side of the outline between the vertices of two points is a sum of shares of point, partner and hub; so is its place after retraction.
void MarkerRing::place(const ObjectPoints &object, const DemEngine &points, int per_point, double retraction)
{
  per_point_ = per_point;
  inner_start_.clear();
  markers_.resize(static_cast<std::size_t>(object.n_ring) * per_point);
  from_hub_.resize(markers_.size());
  outline_.resize(markers_.size());
  gaps_.resize(markers_.size());
  look_at_vertices(object, points);
  const double *x_hub = points.x[object.hub];
  const Vector2 u_hub(points.v[object.hub][0], points.v[object.hub][1]);
  if (points.object_point[object.hub][Column::SPOKES] == 0.0) retraction = 0.0;
  int of_point = 0, point = 0;  // which of a point's markers, whose
  for (int m = 0; m < size(); ++m, ++of_point) {
    if (of_point == per_point) of_point = 0, ++point;
    Marker &marker = markers_[m];
    marker.point = point;
    const double t = (of_point + 0.5) / per_point - 0.5;
    marker.partner = t < 0.0 ? (point > 0 ? point : object.n_ring) - 1 : (point + 1 < object.n_ring ? point + 1 : 0);
    const double along = std::abs(t);
    const Vertex &a = vertices_[marker.point], &b = vertices_[marker.partner];
    const double excess_a = (1.0 - along) * a.excess, excess_b = along * b.excess;
    outline_[m] = (1.0 - along + excess_a) * a.from_hub + (along + excess_b) * b.from_hub;
    const double distance = outline_[m].norm(), pull = distance > 0.0 ? std::min(0.5, retraction / distance) : 0.0;
    marker.along = (along + excess_b) / (1.0 + (excess_a + excess_b));
    marker.share = pull - (1.0 - pull) * (excess_a + excess_b);
    from_hub_[m] = (1.0 - pull) * outline_[m];
    const Vector2 u = marker.point_weight() * a.velocity + marker.partner_weight() * b.velocity + marker.share * u_hub;
    for (int d = 0; d < 2; ++d) {
      marker.x[d] = x_hub[d] + from_hub_[m][d];
      marker.u[d] = u[d];
    }
  }
  for (int m = 0; m + 1 < size(); ++m) gaps_[m] = (from_hub_[m + 1] - from_hub_[m]).norm();
  gaps_.back() = (from_hub_.front() - from_hub_.back()).norm();
  const PolygonArea inside = polygon_area(from_hub_);
  area_ = inside.area;
  outline_area_ = polygon_area(outline_).area;
  centroid_ = {x_hub[0] + inside.centroid.x(), x_hub[1] + inside.centroid.y()};
}

double MarkerRing::perimeter() const { return std::accumulate(gaps_.begin(), gaps_.end(), 0.0); }

Vec<2> MarkerRing::side(int m) const
{
  const Vec<2> &a = markers_[before(m)].x, &b = markers_[after(m)].x;
  return {0.5 * (b[1] - a[1]), -0.5 * (b[0] - a[0])};
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
