#include "coupling/marker_ring.h"

#include <algorithm>
#include <cmath>

#include "liggghts_plugins/objects/outline.h"

namespace swellflow {

void MarkerRing::place(const ObjectPoints &object, const DemEngine &points, double retraction)
{
  positions_.resize(object.n_ring);
  shares_.resize(object.n_ring);
  from_hub_.resize(object.n_ring);
  const double *hub = points.x[object.hub];
  for (int k = 0; k < object.n_ring; ++k) {
    const double *x = points.x[object.ring[k]];
    const double distance = std::hypot(x[0] - hub[0], x[1] - hub[1]);
    shares_[k] = distance > 0.0 ? std::min(0.5, retraction / distance) : 0.0;
    for (int d = 0; d < 2; ++d) {
      from_hub_[k][d] = (1.0 - shares_[k]) * (x[d] - hub[d]);
      positions_[k][d] = hub[d] + from_hub_[k][d];
    }
  }
  const OutlineShape shape = outline_shape(from_hub_);
  area_ = shape.area;
  centroid_ = {hub[0] + shape.centroid.x(), hub[1] + shape.centroid.y()};
}

double MarkerRing::gap(int k) const
{
  const Vec<2> &a = positions_[k], &b = positions_[after(k)];
  return std::hypot(b[0] - a[0], b[1] - a[1]);
}

Vec<2> MarkerRing::outward(int k) const
{
  const Vec<2> &a = positions_[before(k)], &b = positions_[after(k)];
  return {0.5 * (b[1] - a[1]), -0.5 * (b[0] - a[0])};
}

double MarkerRing::dilation_rate(const ObjectPoints &object, const DemEngine &points) const
{
  if (area_ <= 0.0) return 0.0;
  double flux = 0.0;
  for (int k = 0; k < size(); ++k) {
    const Vec<2> b = outward(k);
    for (int d = 0; d < 2; ++d)
      flux += b[d] * ((1.0 - shares_[k]) * points.v[object.ring[k]][d] + shares_[k] * points.v[object.hub][d]);
  }
  return flux / (2.0 * area_);
}

}  // namespace swellflow
