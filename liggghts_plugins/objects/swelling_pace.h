// How fast objects swell beside what has to keep up with them; free of LIGGGHTS.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

namespace swellflow {

/// The fluid around the objects; without one all are zero.
struct PaceOfFluid {
  double density = 0.0, kinematic_viscosity = 0.0;
  double speed = 0.0;  ///< root mean square of the velocity
};

/// w = |dD/dt| of the natural diameter D is the speed at which two neighbours close in on each other.
struct PaceOfObject {
  double closing_speed, diameter, area, density;
  double pressure;  ///< of contacts; > 0 when the object is pressed
};

/// Sums over objects and moments, each counted by its growth A w: what is said of a bed, or of a whole run, is the mean over the area that was grown.
class SwellingPace {
public:
  /// The weight of viscosity beside inertia in a dense flow of discs, K = J + alpha I^2 (Trulsson, Andreotti & Claudin 2012).
  static constexpr double alpha = 0.635;
  /// Where the two measures below are no longer small: docs/fix_swell.md has what happens below and beyond.
  static constexpr double flow_bound = 0.3, contact_bound = 0.02;

  void add(const PaceOfObject &object, const PaceOfFluid &fluid)
  {
    const double w = object.closing_speed, D = object.diameter, grown = object.area * w;
    if (w == 0.0) return;
    if (fluid.kinematic_viscosity > 0.0) flow_ = std::max(flow_, w / (fluid.kinematic_viscosity / D + fluid.speed));
    if (object.pressure <= 0.0) return;
    inertia_ += grown * (object.density * w * w + fluid.density * fluid.kinematic_viscosity * w / (alpha * D));
    work_ += grown * object.pressure;
  }

  /// Largest w / (nu/D + U): the growth of a diameter over the speed at which the flow around it adapts.
  double against_flow() const { return flow_; }
  /// The inertial number sqrt(I^2 + J/alpha) with I = w sqrt(rho/p) and J = rho_f nu (w/D) / p. 0 when nothing that grows is pressed.
  double against_contacts() const { return work_ > 0.0 ? std::sqrt(inertia_ / work_) : 0.0; }

  /// For the sum over ranks: two sums and a largest value.
  std::array<double, 2> sums() const { return {inertia_, work_}; }
  static SwellingPace of(const std::array<double, 2> &sums, double flow)
  {
    SwellingPace pace;
    pace.inertia_ = sums[0], pace.work_ = sums[1], pace.flow_ = flow;
    return pace;
  }

private:
  double flow_ = 0.0, inertia_ = 0.0, work_ = 0.0;
};

}  // namespace swellflow
