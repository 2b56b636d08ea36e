#include "polygon.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace swellflow {

namespace {

struct Bounds {
  Vector2 low = Vector2::Constant(std::numeric_limits<double>::infinity()), high = -low;

  void include(const Vector2 &x)
  {
    low = low.cwiseMin(x);
    high = high.cwiseMax(x);
  }
  bool meets(const Bounds &other) const { return (low.array() <= other.high.array()).all() && (other.low.array() <= high.array()).all(); }
};

Bounds bounds_of(const Polygon &polygon)
{
  Bounds bounds;
  for (const Vector2 &x : polygon) bounds.include(x);
  return bounds;
}

Bounds bounds_of_edge(const Vector2 &p, const Vector2 &q)
{
  Bounds bounds;
  bounds.include(p);
  bounds.include(q);
  return bounds;
}

double distance_to_edge(const Vector2 &p, const Vector2 &q, const Vector2 &x)
{
  const Vector2 edge = q - p;
  const double t = std::clamp((x - p).dot(edge) / edge.squaredNorm(), 0.0, 1.0);
  return (x - p - t * edge).norm();
}

/// Whether the segments p q and r s have a point in common, ends included.
bool segments_meet(const Vector2 &p, const Vector2 &q, const Vector2 &r, const Vector2 &s)
{
  if (!bounds_of_edge(p, q).meets(bounds_of_edge(r, s))) return false;
  const double a = cross(q - p, r - p), b = cross(q - p, s - p), c = cross(s - r, p - r), d = cross(s - r, q - r);
  return a * b <= 0.0 && c * d <= 0.0;
}

bool folds_back(const Vector2 &before, const Vector2 &corner, const Vector2 &behind)
{
  return cross(corner - before, behind - corner) == 0.0 && (corner - before).dot(behind - corner) < 0.0;
}

/// Shares of the way from p to q at which it crosses the polygon, and its two ends.
std::vector<double> crossings(const Vector2 &p, const Vector2 &q, const Polygon &polygon)
{
  std::vector<double> shares{0.0, 1.0};
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Vector2 &r = polygon[k], edge = polygon[after(polygon, k)] - r;
    const double sine = cross(q - p, edge);
    if (sine == 0.0) continue;
    const double t = cross(r - p, edge) / sine, s = cross(r - p, q - p) / sine;
    if (t > 0.0 && t < 1.0 && s >= 0.0 && s <= 1.0) shares.push_back(t);
  }
  std::sort(shares.begin(), shares.end());
  return shares;
}

/// How deep the vertices of `a` lie in `b`, and the middles of the pieces into which `b` cuts the edges of `a`; these are looked at a little inside of `a`, so that
/// polygons that coincide are seen, and those that share a side from the two sides of it are not.
double depth_of_rim(const Polygon &a, const Polygon &b)
{
  double deepest = 0.0;
  const auto look_at = [&](const Vector2 &x) {
    if (contains(b, x)) deepest = std::max(deepest, distance_to_boundary(b, x));
  };
  for (std::size_t k = 0; k < a.size(); ++k) {
    const Vector2 &p = a[k], &q = a[after(a, k)], inwards = 1e-6 * Vector2(p.y() - q.y(), q.x() - p.x());
    look_at(p);
    const std::vector<double> shares = crossings(p, q, b);
    for (std::size_t n = 1; n < shares.size(); ++n) look_at(p + 0.5 * (shares[n - 1] + shares[n]) * (q - p) + inwards);
  }
  return deepest;
}

bool rims_meet(const Polygon &a, const Polygon &b)
{
  const Bounds around_b = bounds_of(b);
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Vector2 &p = a[i], &q = a[after(a, i)];
    if (!bounds_of_edge(p, q).meets(around_b)) continue;
    for (std::size_t j = 0; j < b.size(); ++j)
      if (segments_meet(p, q, b[j], b[after(b, j)])) return true;
  }
  return false;
}

}  // namespace

double mean_square_radius(const Polygon &polygon)
{
  double twice_area = 0.0, sum = 0.0;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Vector2 &p = polygon[k], &q = polygon[after(polygon, k)];
    twice_area += cross(p, q);
    sum += cross(p, q) * (p.dot(p) + p.dot(q) + q.dot(q));
  }
  return sum / (6.0 * twice_area);
}

bool contains(const Polygon &polygon, const Vector2 &x)
{
  bool inside = false;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Vector2 &p = polygon[k], &q = polygon[after(polygon, k)];
    if ((p.y() > x.y()) == (q.y() > x.y())) continue;
    if (x.x() < p.x() + (x.y() - p.y()) / (q.y() - p.y()) * (q.x() - p.x())) inside = !inside;
  }
  return inside;
}

double distance_to_boundary(const Polygon &polygon, const Vector2 &x)
{
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < polygon.size(); ++k) nearest = std::min(nearest, distance_to_edge(polygon[k], polygon[after(polygon, k)], x));
  return nearest;
}

std::optional<std::pair<std::size_t, std::size_t>> self_intersection(const Polygon &polygon)
{
  const std::size_t n = polygon.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Vector2 &p = polygon[i], &q = polygon[after(polygon, i)];
    if (folds_back(p, q, polygon[after(polygon, after(polygon, i))])) return std::pair(i, after(polygon, i));
    for (std::size_t j = i + 2; j < n; ++j)
      if (after(polygon, j) != i && segments_meet(p, q, polygon[j], polygon[after(polygon, j)])) return std::pair(i, j);
  }
  return std::nullopt;
}

double overlap_depth(const Polygon &a, const Polygon &b, const Vector2 &from_a_to_b)
{
  Polygon moved = b;
  for (Vector2 &x : moved) x += from_a_to_b;
  if (!bounds_of(a).meets(bounds_of(moved))) return 0.0;
  if (!rims_meet(a, moved) && !contains(a, moved[0]) && !contains(moved, a[0])) return 0.0;
  return std::max(depth_of_rim(a, moved), depth_of_rim(moved, a));
}

double overlap_depth(const Polygon &a, double R, const Vector2 &from_a_to_b)
{
  const double distance = distance_to_boundary(a, from_a_to_b);
  return std::max(0.0, contains(a, from_a_to_b) ? R + distance : R - distance);
}

}  // namespace swellflow
