// The smooth shape that an object has before it is made of points. Free of LIGGGHTS.
#pragma once

#include "polygon.h"

namespace swellflow {

enum class PointSpacing { arc, angle };

/// A closed curve about its area centroid, counter-clockwise, with the area of a disc of diameter 1.
class Contour {
public:
  static Contour disk();
  static Contour ellipse(double axis_x, double axis_y);
  /// Of a simple polygon of any size, place and sense.
  static Contour polygon(Polygon vertices);

  bool is_round() const { return kind_ == Kind::round; }
  /// Diameter of the disc that has the area of what the contour was made from.
  double own_diameter() const { return own_diameter_; }
  /// n of its points, at equal distances along it or at equal angles about the centroid. A disc's and an ellipse's first point lies on the x axis, a polygon's is its
  /// first vertex, or the point on the x axis for equal angles; n = 0: a polygon's own vertices. Throws std::invalid_argument.
  Polygon points(int n, PointSpacing spacing) const;
  /// Mean of r^2 over the area: the moment of inertia of the solid shape over its mass.
  double mean_square_radius() const { return mean_square_radius_; }
  /// A circle about the centroid.
  bool lies_within(double radius) const;
  /// Of a place inside from the contour, to 1e-6.
  double distance(const Vector2 &inside) const { return distance_to_boundary(fine_, inside); }

private:
  enum class Kind { round, ellipse, polygon };
  Contour(Kind kind, double own_diameter) : kind_(kind), own_diameter_(own_diameter) {}
  Vector2 at_angle(double angle) const;
  Polygon equal_arcs_of_polygon(int n) const;
  Polygon equal_arcs_of_ellipse(int n) const;

  Kind kind_;
  double own_diameter_, a_ = 0.5, b_ = 0.5;  // a_, b_: half axes
  double mean_square_radius_ = 0.125;
  Polygon fine_;  // the polygon itself, or one that is as good as the curve; none of a disc
};

}  // namespace swellflow
