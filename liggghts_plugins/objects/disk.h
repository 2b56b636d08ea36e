// A deformable disc: a closed ring of mass points about a hub. Per unit depth; free of LIGGGHTS.
#pragma once

#include <Eigen/Core>

namespace swellflow {

using Vector2 = Eigen::Vector2d;

/// How the mass of a disc is shared among its points. hub_half gives the ring exactly the moment of inertia of the solid
/// disc (half the mass at R) and no stiff hub mode; equal is M = rho_s V_s / N_l of Guinea, Toriu and Ushijima (2022).
enum class MassShare { hub_half, equal };

struct Disk {
  double diameter = 0.0;
  int ring_points = 20;
  double density = 0.0;
  double cds_ratio = 0.2;  ///< radius of the contact detection spheres, the hub's too, over the diameter
  MassShare share = MassShare::hub_half;

  double mass() const;
  double hub_mass() const;
  double ring_point_mass() const;
  double spoke_length() const { return 0.5 * diameter; }
  double ring_spring_length() const;   ///< the chord between neighbouring ring points
  double cds_radius() const { return cds_ratio * diameter; }
  Vector2 ring_point(int k) const;     ///< from the hub, counter-clockwise, 0 on the x axis
};

}  // namespace swellflow
