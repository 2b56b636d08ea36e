// The markers of one object: a closed polygon, a little inside the ring of points.
#pragma once

#include <vector>

#include "coupling/dem_engine.h"
#include "fluid/grid.h"
#include "liggghts_plugins/fluid_partner.h"
#include "liggghts_plugins/objects/disk.h"

namespace swellflow {

/// Marker k stands for ring point k. 2-D, per unit depth.
class MarkerRing {
public:
  /// Each marker lies `retraction` [length] from its ring point towards the hub, but at most half the way. All points need current positions.
  void place(const ObjectPoints &object, const DemEngine &points, double retraction);

  const Vec<2> &position(int k) const { return positions_[k]; }
  double share(int k) const { return shares_[k]; }    ///< of the way to the hub
  double gap(int k) const;                            ///< distance to the next marker
  double spacing(int k) const { return 0.5 * (gap(k) + gap(before(k))); }
  const Vec<2> &centroid() const { return centroid_; }

  /// Outward normal times the spacing, b.
  Vec<2> outward(int k) const;

  /// (dA/dt) / (2A) of the area A inside the markers, as the velocities of ring and hub make it change: sum of U . b / (2A), with U the markers'
  /// velocities. Ghosts need current velocities too.
  double dilation_rate(const ObjectPoints &object, const DemEngine &points) const;

private:
  int size() const { return static_cast<int>(positions_.size()); }
  int before(int k) const { return k > 0 ? k - 1 : size() - 1; }
  int after(int k) const { return k + 1 < size() ? k + 1 : 0; }

  std::vector<Vec<2>> positions_;
  std::vector<double> shares_;
  std::vector<Vector2> from_hub_;
  double area_ = 0.0;
  Vec<2> centroid_{};
};

}  // namespace swellflow
