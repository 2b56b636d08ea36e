// The markers of one object: a closed polygon, a little inside its outline, and as fine as the fluid's cells ask for.
#pragma once

#include <span>
#include <vector>

#include "coupling/dem_engine.h"
#include "fluid/grid.h"
#include "liggghts_plugins/fluid_partner.h"
#include "liggghts_plugins/objects/vector2.h"

namespace swellflow {

/// Each ring point has the same number of markers, spread over the half edges on its two sides. A marker moves with its point, the next point on its side and the
/// hub, in fixed shares, and what force it bears is theirs in the same shares. 2-D, per unit depth.
class MarkerRing {
public:
  struct Marker {
    int point, partner;      ///< ring points, 0 … n_ring - 1
    double along;            ///< share of the partner in what is not the hub's
    double share;            ///< of the hub, at most 1/2; < 0 where the outline, and the marker with it, lies beyond the points
    Vec<2> x, u;
    double point_weight() const { return (1.0 - share) * (1.0 - along); }
    double partner_weight() const { return (1.0 - share) * along; }
  };

  /// A part of a marker inside, as its point or the hub bears it: the parts of one lie on the same spot, each with the velocity of the whole.
  struct InnerMarker {
    Vec<2> x, u;
    double spacing;  ///< share in the area that the marker stands for, over h
  };

  /// Markers lie `retraction` [length] from the outline towards the hub, but at most half the way; those of an object without spokes lie on its outline. All points,
  /// ghosts too, need current positions and velocities.
  void place(const ObjectPoints &object, const DemEngine &points, int per_point, double retraction);

  /// Fills the inside with layers of markers, about h apart, between those on the outline and the hub. After `place`.
  void fill(const ObjectPoints &object, const DemEngine &points, double h);
  /// Those that the ring point k bears, n_ring: the hub. None unless filled.
  std::span<const InnerMarker> inner(int k) const;

  /// The markers of ring point k are those at k * per_point … (k + 1) * per_point - 1.
  const Marker &marker(int m) const { return markers_[m]; }
  int per_point() const { return per_point_; }
  double gap(int m) const { return gaps_[m]; }        ///< distance to the next marker
  double spacing(int m) const { return 0.5 * (gap(m) + gap(before(m))); }
  double perimeter() const;
  Vec<2> side(int m) const;                              ///< half of the line from the marker before to that behind, turned outwards: their sum vanishes
  const Vec<2> &centroid() const { return centroid_; }   ///< of the area inside the markers
  double area() const { return area_; }                  ///< inside the markers
  double outline_area() const { return outline_area_; }  ///< inside the outline

  /// (dA/dt) / (2A) of the area A inside the markers: sum of u . b / (2A), b being the outward normal times the spacing.
  double dilation_rate() const;

private:
  /// A ring point; the outline's vertex is 1 + excess times as far from the hub: outline_point().
  struct Vertex {
    Vector2 from_hub, velocity;
    double excess;
  };
  void look_at_vertices(const ObjectPoints &object, const DemEngine &points);
  int size() const { return static_cast<int>(markers_.size()); }
  int before(int m) const { return m > 0 ? m - 1 : size() - 1; }
  int after(int m) const { return m + 1 < size() ? m + 1 : 0; }

  int per_point_ = 1;
  std::vector<Marker> markers_;
  std::vector<InnerMarker> inner_;
  std::vector<int> inner_start_;  // by ring point, then hub; empty unless filled
  std::vector<Vertex> vertices_;
  std::vector<Vector2> from_hub_, outline_;
  std::vector<double> gaps_;
  double area_ = 0.0, outline_area_ = 0.0;
  Vec<2> centroid_{};
};

}  // namespace swellflow
