// A body force that holds the mean velocity of a periodic flow.
#pragma once

#include <array>

#include "fluid/checkpoint.h"

namespace swellflow {

/// Integral control per direction. In a step, dU/dt = g - r with r what walls and objects take away: r of the last step is known from its g, and is what the next
/// one is set against; a quarter of what the mean velocity lacks is asked for on top:
///     g = [ g - (U - U_before) / dt_before ] + (U_wanted - U) / (4 dt)
/// In a steady flow g no longer changes only when U = U_wanted. The slower r answers, the faster U arrives: within some 4 steps where inertia rules.
template <int Dim> class FlowRate {
public:
  /// controlled: the directions in which `update` changes the body force.
  explicit FlowRate(const std::array<bool, Dim> &controlled) : controlled_(controlled) {}

  bool active() const
  {
    bool any = false;
    for (const bool controlled : controlled_) any = any || controlled;
    return any;
  }

  /// The body force per mass for a coming step of length dt, U being the mean velocity now.
  void update(const Vec<Dim> &mean_velocity, const Vec<Dim> &wanted, double dt, Vec<Dim> &body_force)
  {
    for (int d = 0; d < Dim; ++d) {
      if (!controlled_[d]) continue;
      if (dt_before_ > 0.0) g_[d] -= (mean_velocity[d] - before_[d]) / dt_before_;
      g_[d] += (wanted[d] - mean_velocity[d]) / (steps * dt);
      before_[d] = mean_velocity[d];
      body_force[d] = g_[d];
    }
    dt_before_ = dt;
  }

  /// Collective.
  void keep(Checkpoint &file)
  {
    file.common("flow rate, force", g_.data(), Dim);
    file.common("flow rate, velocity before", before_.data(), Dim);
    file.number("flow rate, step before", dt_before_);
  }

private:
  static constexpr double steps = 4.0;
  std::array<bool, Dim> controlled_;
  Vec<Dim> g_{}, before_{};
  double dt_before_ = 0.0;
};

}  // namespace swellflow
