#include "overlap.h"

#include <algorithm>
#include <cmath>

namespace swellflow {

namespace {

constexpr double touching = 1e-9;  ///< of the sum of the radii: round-off, not overlap

/// Square cells at least one largest diameter wide, so that all partners lie in a cell's eight neighbours or in itself.
class Cells {
public:
  Cells(const std::vector<Circle> &circles, const PlaneBox &box) : box_(box)
  {
    double widest = 0.0;
    for (const Circle &circle : circles) widest = std::max(widest, 2.0 * circle.radius);
    const double coarsest = std::sqrt(box.length().prod() / (circles.size() + 1.0));
    // At most one a circle, also in a box that is much longer than wide.
    for (int d = 0; d < 2; ++d) n_[d] = 1 + whole(box.length()[d] / std::max(widest, coarsest) - 1.0, circles.size());
    members_.resize(static_cast<std::size_t>(n_[0]) * n_[1]);
    for (std::size_t i = 0; i < circles.size(); ++i) members_[cell(circles[i].centre)].push_back(static_cast<int>(i));
  }

  template <typename Visit>
  void visit_around(const Vector2 &x, const Visit &visit) const
  {
    const std::array<int, 2> c = position(x);
    std::vector<std::size_t> seen;  // a direction with fewer than three cells would meet one twice
    for (int j = -1; j <= 1; ++j)
      for (int i = -1; i <= 1; ++i) {
        std::array<int, 2> at{c[0] + i, c[1] + j};
        if (!wrap(at)) continue;
        const std::size_t index = static_cast<std::size_t>(at[1]) * n_[0] + at[0];
        if (std::find(seen.begin(), seen.end(), index) != seen.end()) continue;
        seen.push_back(index);
        for (int member : members_[index]) visit(member);
      }
  }

private:
  /// Rounded down, from 0 to `most`; 0 of what is no number, as in a run that is about to end for that.
  static int whole(double value, double most) { return value > 0.0 ? static_cast<int>(std::min(value, most)) : 0; }

  std::array<int, 2> position(const Vector2 &x) const
  {
    std::array<int, 2> at;
    for (int d = 0; d < 2; ++d) {
      const double part = (x[d] - box_.low[d]) / box_.length()[d];
      const double inside = box_.periodic[d] ? part - std::floor(part) : part;
      at[d] = whole(inside * n_[d], n_[d] - 1);
    }
    return at;
  }
  std::size_t cell(const Vector2 &x) const
  {
    const std::array<int, 2> at = position(x);
    return static_cast<std::size_t>(at[1]) * n_[0] + at[0];
  }
  bool wrap(std::array<int, 2> &at) const
  {
    for (int d = 0; d < 2; ++d) {
      if (box_.periodic[d]) at[d] = (at[d] + n_[d]) % n_[d];
      if (at[d] < 0 || at[d] >= n_[d]) return false;
    }
    return true;
  }

  const PlaneBox &box_;
  std::array<int, 2> n_;
  std::vector<std::vector<int>> members_;
};

double depth_of(const Footprint &a, const Footprint &b, const Vector2 &from_a_to_b)
{
  if (a.outline.empty() && b.outline.empty()) return a.circle.radius + b.circle.radius - from_a_to_b.norm();
  if (a.outline.empty()) return overlap_depth(b.outline, a.circle.radius, -from_a_to_b);
  if (b.outline.empty()) return overlap_depth(a.outline, b.circle.radius, from_a_to_b);
  return overlap_depth(a.outline, b.outline, from_a_to_b);
}

}  // namespace

Vector2 PlaneBox::difference(const Vector2 &a, const Vector2 &b) const
{
  Vector2 d = a - b;
  for (int i = 0; i < 2; ++i)
    if (periodic[i]) d[i] -= length()[i] * std::round(d[i] / length()[i]);
  return d;
}

Vector2 PlaneBox::wrapped(Vector2 x) const
{
  for (int d = 0; d < 2; ++d) {
    if (!periodic[d]) continue;
    x[d] -= length()[d] * std::floor((x[d] - low[d]) / length()[d]);
    if (x[d] < low[d] || x[d] >= high[d]) x[d] = low[d];  // by round-off
  }
  return x;
}

void for_each_overlapping_pair(const std::vector<Circle> &circles, int first_new, const PlaneBox &box,
                               const std::function<void(int, int, const Vector2 &)> &visit)
{
  const Cells cells(circles, box);
  for (int j = first_new; j < static_cast<int>(circles.size()); ++j)
    cells.visit_around(circles[j].centre, [&](int i) {
      if (i >= j) return;
      const double reach = circles[i].radius + circles[j].radius;
      const Vector2 way = box.difference(circles[j].centre, circles[i].centre);
      if (reach - way.norm() > touching * reach) visit(i, j, way);
    });
}

std::optional<Overlap> deepest_overlap(const std::vector<Footprint> &objects, int first_new, const PlaneBox &box)
{
  std::vector<Circle> circles;
  for (const Footprint &object : objects) circles.push_back(object.circle);
  std::optional<Overlap> deepest;
  for_each_overlapping_pair(circles, first_new, box, [&](int i, int j, const Vector2 &way) {
    const double depth = depth_of(objects[i], objects[j], way);
    if (depth > touching * (circles[i].radius + circles[j].radius) && (!deepest || depth > deepest->depth)) deepest = Overlap{i, j, depth};
  });
  return deepest;
}

}  // namespace swellflow
