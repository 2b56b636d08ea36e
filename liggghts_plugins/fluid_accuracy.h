// The worst that the reports of a fluid have shown since a run began.
#pragma once

#include <algorithm>

#include "fluid_partner.h"

namespace swellflow {

class FluidAccuracy {
public:
  /// speed_of_points: the largest of all objects' points, which counts where they move, or grow, in a fluid that they hardly stir.
  void add(const FluidReport &report, double cell, double speed_of_points)
  {
    if (report.step <= 0.0) return;
    speed_ = std::max({speed_, report.cfl * cell / report.step, speed_of_points});
    slip_ = std::max(slip_, report.mean_slip);
    divergence_ = std::max(divergence_, report.max_divergence * cell);
    cfl = std::max(cfl, report.cfl);
    momentum_error = std::max(momentum_error, report.momentum_error);
    marker_gap = std::max(marker_gap, report.marker_gap);
  }
  /// Over the largest speed that any cell or point has had.
  double slip() const { return speed_ > 0.0 ? slip_ / speed_ : 0.0; }
  double speed() const { return speed_; }
  double divergence() const { return speed_ > 0.0 ? divergence_ / speed_ : 0.0; }

  double cfl = 0.0, momentum_error = 0.0, marker_gap = 0.0;

private:
  double speed_ = 0.0, slip_ = 0.0, divergence_ = 0.0;
};

}  // namespace swellflow
