// What an object is made of: a closed ring of mass points about a hub, before it has a size, a place and a density. Free of LIGGGHTS.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "contour.h"

namespace swellflow {

/// How the mass is shared among the points. hub_half: the hub has as much as gives the points the moment of inertia of the solid shape (half of it for a disc), and the
/// points' centre of mass is the centroid; no stiff hub mode arises. equal: M = rho_s V_s / N_l of Guinea, Toriu and Ushijima (2022).
enum class MassShare { hub_half, equal };

struct ShapeRequest {
  std::shared_ptr<const Contour> contour;
  int points = 20;                 ///< on the ring; 0: a polygon's own vertices
  PointSpacing spacing = PointSpacing::arc;
  bool spokes = true;              ///< springs to the hub; without, the hub has next to no mass and follows the ring
  double cds = 0.2;                ///< radius of the contact detection spheres over the diameter
  std::optional<double> reach = std::nullopt;  ///< how far they reach beyond the outline, over the diameter, at most their radius; none: that
  int cds_points = 0;              ///< ring points with a sphere; 0: all
  bool hub_cds = true;
  MassShare share = MassShare::hub_half;
};

/// An object of diameter 1: lengths scale with the diameter, which is that of the disc of the same area. Positions are about the contour's centroid.
struct Shape {
  struct RingPoint {
    Vector2 x;
    double outline_offset;  ///< by which the outline lies beyond it, away from the hub
    double weight;          ///< of its mass, over the mean of the ring's
    double ring_length, spoke_length;  ///< natural lengths of the springs to the next point and to the hub
    bool has_cds;
  };

  std::vector<RingPoint> ring;  ///< counter-clockwise
  Vector2 hub = Vector2::Zero(), centre_of_mass = Vector2::Zero();
  double hub_share = 0.0;       ///< of the mass
  bool spokes = true, hub_has_cds = true, is_round = false;
  double cds = 0.2, reach = 0.2;
  MassShare share = MassShare::hub_half;
  Polygon outline;
  double outline_area = 0.0;
  double mean_square_radius = 0.0;  ///< mean of r^2 over the smooth shape, about its centroid

  double natural_area(double diameter) const;  ///< inside the polygon of the outline
  double longest_side() const;                 ///< of that polygon
  double mass(double diameter, double density) const;
  double hub_mass(double mass) const;
  double ring_point_mass(int k, double mass) const;
};

/// Throws std::invalid_argument with rule, value and remedy when there is no such object.
Shape make_shape(const ShapeRequest &request);

}  // namespace swellflow
