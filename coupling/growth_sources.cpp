#include "coupling/growth_sources.h"

#include <algorithm>
#include <cmath>

namespace swellflow {

std::vector<Vector2> shrunk(std::vector<Vector2> outline, double depth)
{
  double least = HUGE_VAL;
  for (const Vector2 &vertex : outline) least = std::min(least, vertex.norm());
  const double scale = std::max(0.1, 1.0 - depth / least);
  for (Vector2 &vertex : outline) vertex *= scale;
  return outline;
}

/// Each edge and the hub make a triangle, which is cut into strips at the hub and these into layers.
void add_source_points(const std::vector<Vector2> &outline, const Vec<2> &hub, double spacing, std::vector<SourcePoint> &points)
{
  const std::size_t first = points.size();
  double whole = 0.0;
  for (std::size_t k = 0; k < outline.size(); ++k) {
    const Vector2 &a = outline[k], &b = outline[k + 1 < outline.size() ? k + 1 : 0];
    const double area = 0.5 * (a.x() * b.y() - a.y() * b.x());
    if (!(area > 0.0)) continue;
    whole += area;
    const int strips = std::max(1, static_cast<int>(std::ceil((b - a).norm() / spacing)));
    const int layers = std::max(1, static_cast<int>(std::ceil(std::max(a.norm(), b.norm()) / spacing)));
    for (int s = 0; s < strips; ++s) {
      const Vector2 end = a + (s + 0.5) / strips * (b - a);
      for (int l = 0; l < layers; ++l) {
        const Vector2 x = (l + 0.5) / layers * end;
        points.push_back({{hub[0] + x.x(), hub[1] + x.y()}, area / strips * (2 * l + 1) / (layers * layers)});
      }
    }
  }
  if (whole == 0.0) points.push_back({hub, whole = 1.0});
  for (std::size_t p = first; p < points.size(); ++p) points[p].share /= whole;
}

}  // namespace swellflow
