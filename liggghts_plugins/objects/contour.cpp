#include "contour.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "outline.h"

namespace swellflow {

using std::numbers::pi;

namespace {

/// Length along an ellipse, x = a cos t, y = b sin t, from t = 0.
class EllipseArc {
public:
  EllipseArc(double a, double b) : a_(a), b_(b)
  {
    for (int k = 0; k < intervals; ++k) length_[k + 1] = length_[k] + piece(k * width, (k + 1) * width);
  }

  double whole() const { return length_[intervals]; }
  /// The t at that length: Newton's method from the beginning of the interval that it lies in.
  double parameter(double length) const
  {
    const int k = static_cast<int>(std::upper_bound(length_, length_ + intervals, length) - length_) - 1;
    double t = k * width;
    for (int step = 0; step < 20; ++step) {
      const double missing = length - length_[k] - piece(k * width, t);
      t += missing / speed(t);
      if (std::abs(missing) < 1e-15) break;
    }
    return t;
  }

private:
  static constexpr int intervals = 512;
  static constexpr double width = 2.0 * pi / intervals;

  double speed(double t) const { return std::hypot(a_ * std::sin(t), b_ * std::cos(t)); }
  /// Gauss and Legendre's rule with three points.
  double piece(double from, double to) const
  {
    const double middle = 0.5 * (from + to), half = 0.5 * (to - from), node = half * std::sqrt(0.6);
    return half / 9.0 * (5.0 * speed(middle - node) + 8.0 * speed(middle) + 5.0 * speed(middle + node));
  }

  double a_, b_, length_[intervals + 1] = {};
};

}  // namespace

Contour Contour::disk() { return Contour(Kind::round, 1.0); }

Contour Contour::ellipse(double axis_x, double axis_y)
{
  Contour ellipse(Kind::ellipse, std::sqrt(axis_x * axis_y));
  ellipse.a_ = 0.5 * axis_x / ellipse.own_diameter_;
  ellipse.b_ = 0.5 * axis_y / ellipse.own_diameter_;
  ellipse.mean_square_radius_ = 0.25 * (ellipse.a_ * ellipse.a_ + ellipse.b_ * ellipse.b_);
  constexpr int chords = 1440;
  for (int k = 0; k < chords; ++k) {
    const double t = 2.0 * pi * k / chords;
    ellipse.fine_.emplace_back(ellipse.a_ * std::cos(t), ellipse.b_ * std::sin(t));
  }
  return ellipse;
}

Contour Contour::polygon(Polygon vertices)
{
  const Vector2 near = vertices[0];  // so that far from the origin no digits are lost
  for (Vector2 &x : vertices) x -= near;
  const OutlineShape shape = outline_shape(vertices);
  if (shape.area < 0.0) std::reverse(vertices.begin() + 1, vertices.end());
  Contour polygon(Kind::polygon, std::sqrt(4.0 * std::abs(shape.area) / pi));
  for (Vector2 &x : vertices) x = (x - shape.centroid) / polygon.own_diameter_;
  polygon.fine_ = std::move(vertices);
  polygon.mean_square_radius_ = swellflow::mean_square_radius(polygon.fine_);
  return polygon;
}

bool Contour::lies_within(double radius) const
{
  return std::all_of(fine_.begin(), fine_.end(), [radius](const Vector2 &x) { return x.norm() <= radius; });
}

Polygon Contour::points(int n, PointSpacing spacing) const
{
  if (n == 0) return fine_;
  if (kind_ == Kind::polygon && spacing == PointSpacing::arc) return equal_arcs_of_polygon(n);
  if (kind_ == Kind::ellipse && spacing == PointSpacing::arc) return equal_arcs_of_ellipse(n);
  Polygon points;
  for (int k = 0; k < n; ++k) points.push_back(at_angle(2.0 * pi * k / n));
  return points;
}

Vector2 Contour::at_angle(double angle) const
{
  const Vector2 d(std::cos(angle), std::sin(angle));
  if (kind_ == Kind::round) return 0.5 * d;
  if (kind_ == Kind::ellipse) return a_ * b_ / std::hypot(b_ * d.x(), a_ * d.y()) * d;
  int hits = 0;
  Vector2 hit = Vector2::Zero();
  for (std::size_t k = 0; k < fine_.size(); ++k) {
    const Vector2 &p = fine_[k], &q = fine_[after(fine_, k)];
    const double at_p = cross(d, p), at_q = cross(d, q);
    if ((at_p >= 0.0) == (at_q >= 0.0)) continue;
    const Vector2 x = p + at_p / (at_p - at_q) * (q - p);
    if (x.dot(d) <= 0.0) continue;
    hit = x;
    ++hits;
  }
  if (hits != 1)
    throw std::invalid_argument("points at equal angles want an outline that each ray from its centroid leaves once, but the ray at " +
                                std::to_string(static_cast<int>(std::lround(angle * 180.0 / pi))) + " degrees leaves it " + std::to_string(hits) +
                                " times: use 'point_spacing arc' or 'points 0'");
  return hit;
}

Polygon Contour::equal_arcs_of_polygon(int n) const
{
  std::vector<double> length{0.0};
  for (std::size_t k = 0; k < fine_.size(); ++k) length.push_back(length.back() + (fine_[after(fine_, k)] - fine_[k]).norm());
  Polygon points;
  for (std::size_t k = 0; static_cast<int>(points.size()) < n;) {
    const double s = length.back() * points.size() / n;
    while (length[k + 1] <= s) ++k;
    points.push_back(fine_[k] + (s - length[k]) / (length[k + 1] - length[k]) * (fine_[after(fine_, k)] - fine_[k]));
  }
  return points;
}

Polygon Contour::equal_arcs_of_ellipse(int n) const
{
  const EllipseArc arc(a_, b_);
  Polygon points;
  for (int k = 0; k < n; ++k) {
    const double t = arc.parameter(arc.whole() * k / n);
    points.emplace_back(a_ * std::cos(t), b_ * std::sin(t));
  }
  return points;
}

}  // namespace swellflow
