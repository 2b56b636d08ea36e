#include "coupling/marker_ring.h"

#include <algorithm>
#include <cmath>

#include "liggghts_plugins/objects/outline.h"

namespace swellflow {

void MarkerRing::place(const ObjectPoints &object, const DemEngine &points, int per_point, double retraction)
{
  per_point_ = per_point;
  markers_.resize(static_cast<std::size_t>(object.n_ring) * per_point);
  from_hub_.resize(markers_.size());
  outline_.resize(markers_.size());
  const double *x_hub = points.x[object.hub], *u_hub = points.v[object.hub];
  for (int m = 0; m < size(); ++m) {
    Marker &marker = markers_[m];
    marker.point = m / per_point;
    const double t = (m % per_point + 0.5) / per_point - 0.5;
    marker.partner = (marker.point + (t < 0.0 ? object.n_ring - 1 : 1)) % object.n_ring;
    marker.along = std::abs(t);
    const int i = object.ring[marker.point], j = object.ring[marker.partner];
    for (int d = 0; d < 2; ++d)
      outline_[m][d] = (1.0 - marker.along) * points.x[i][d] + marker.along * points.x[j][d] - x_hub[d];
    const double distance = outline_[m].norm();
    marker.share = distance > 0.0 ? std::min(0.5, retraction / distance) : 0.0;
    for (int d = 0; d < 2; ++d) {
      from_hub_[m][d] = (1.0 - marker.share) * outline_[m][d];
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
