#include "circle_cover.h"

#include <algorithm>
#include <cmath>

#include "outline.h"

namespace swellflow {

namespace {

/// Places on the outline, at most `spacing` apart and never in a corner, with the unit normal that leads inside.
struct RimPlace {
  Vector2 x, inwards;
};

std::vector<RimPlace> rim_places(const Polygon &outline, double spacing)
{
  double twice_area = 0.0;
  for (std::size_t k = 0; k < outline.size(); ++k) twice_area += cross(outline[k], outline[after(outline, k)]);
  std::vector<RimPlace> places;
  for (std::size_t k = 0; k < outline.size(); ++k) {
    const Vector2 edge = outline[after(outline, k)] - outline[k];
    const Vector2 left = Vector2(-edge.y(), edge.x()).normalized() * (twice_area < 0.0 ? -1.0 : 1.0);
    const int n = std::max(1, static_cast<int>(std::ceil(edge.norm() / spacing)));
    for (int part = 0; part < n; ++part) places.push_back({outline[k] + (part + 0.5) / n * edge, left});
  }
  return places;
}

/// The largest circle inside that touches the outline at `place`: its centre lies on the medial axis.
Circle touching_circle(const RimPlace &place, const std::vector<RimPlace> &rim, double largest)
{
  double radius = largest;
  for (const RimPlace &other : rim) {
    const Vector2 way = other.x - place.x;
    const double ahead = way.dot(place.inwards);
    if (ahead > 0.0) radius = std::min(radius, way.squaredNorm() / (2.0 * ahead));
  }
  return {place.x + radius * place.inwards, radius};
}

/// What must be covered: corners, rim, and a lattice of places inside.
std::vector<Vector2> samples_of(const Polygon &outline, const std::vector<RimPlace> &rim)
{
  std::vector<Vector2> samples = outline;
  for (const RimPlace &place : rim) samples.push_back(place.x);
  Vector2 low = outline.front(), high = low;
  for (const Vector2 &x : outline) low = low.cwiseMin(x), high = high.cwiseMax(x);
  constexpr int n = 16;
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const Vector2 x = low + (high - low).cwiseProduct(Vector2((i + 0.5) / n, (j + 0.5) / n));
      if (contains(outline, x)) samples.push_back(x);
    }
  return samples;
}

/// The samples that lie in the circle so deep that what is between them does, too.
std::vector<std::size_t> covered_by(const Circle &circle, const std::vector<Vector2> &samples, double depth)
{
  std::vector<std::size_t> covered;
  const double within = circle.radius - depth;
  for (std::size_t k = 0; k < samples.size(); ++k)
    if ((samples[k] - circle.centre).squaredNorm() <= within * within) covered.push_back(k);
  return covered;
}

}  // namespace

// The union of all circles about the medial axis is the shape. Each is made wider by the tolerance; then those that cover most of what is still bare are taken.
std::vector<Circle> covering_circles(const Polygon &outline, double tolerance)
{
  const double spacing = 0.5 * tolerance;
  const std::vector<RimPlace> rim = rim_places(outline, spacing);
  const std::vector<Vector2> samples = samples_of(outline, rim);
  double widest = 0.0;
  for (const Vector2 &x : outline) widest = std::max(widest, (x - outline.front()).norm());
  std::vector<Circle> candidates;
  std::vector<std::vector<std::size_t>> covers;
  const auto propose = [&](const Circle &circle) {
    candidates.push_back(circle);
    covers.push_back(covered_by(circle, samples, 0.5 * spacing));
  };
  // Of a polygon that is nearly round no touching circle need be centred in its middle.
  const Vector2 middle = outline_shape(outline).centroid;
  if (contains(outline, middle)) propose({middle, distance_to_boundary(outline, middle) + tolerance});
  for (const RimPlace &place : rim) {
    const Circle inside = touching_circle(place, rim, widest);
    propose({inside.centre, inside.radius + tolerance});
  }

  std::vector<char> bare(samples.size(), 1);
  std::vector<Circle> chosen;
  for (std::size_t left = samples.size(); left > 0;) {
    std::size_t best = 0, most = 0;
    for (std::size_t c = 0; c < candidates.size(); ++c) {
      const std::size_t gain = std::count_if(covers[c].begin(), covers[c].end(), [&](std::size_t k) { return bare[k]; });
      if (gain > most) best = c, most = gain;
    }
    if (most == 0) {  // a sharp tip, or a place that the candidates leave out: a circle of its own
      const Vector2 x = samples[std::find(bare.begin(), bare.end(), 1) - bare.begin()];
      best = candidates.size();
      propose({x, tolerance + (contains(outline, x) ? distance_to_boundary(outline, x) : 0.0)});
      most = std::count_if(covers[best].begin(), covers[best].end(), [&](std::size_t k) { return bare[k]; });
    }
    for (std::size_t k : covers[best]) bare[k] = 0;
    chosen.push_back(candidates[best]);
    left -= most;
  }
  return chosen;
}

}  // namespace swellflow
