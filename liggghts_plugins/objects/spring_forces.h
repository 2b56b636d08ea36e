// All forces of the springs and dashpots of one object at once: the hot loop of a bed. Free of LIGGGHTS.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "spring_set.h"

namespace swellflow {

/// Ring points, then the hub: positions and velocities in, forces out. Kept from object to object, so that nothing is allocated. What spring_force and dashpot_force of springs.h
/// say, in rows that the compiler can turn into vector instructions.
class SpringForces {
public:
  /// Places x and velocities v of the points with these indices, in rows of three as LIGGGHTS has them; without v there will be no dashpots.
  void gather(const int *ring, int ring_points, int hub, const double *x, const double *v)
  {
    resize(ring_points);
    for (int d = 0; d < 2; ++d) {
      take(d, ring, hub, x, row(PLACE + d), hub_x_[d]);
      if (v) take(d, ring, hub, v, row(VELOCITY + d), hub_v_[d]);
    }
    damped_ = v != nullptr;
  }

  /// The springs are `scale` times the natural ones; a hub without spokes gets no force.
  void find(const SpringSet &natural, const SpringScale &scale)
  {
    if (damped_) find<true>(natural, scale);
    else find<false>(natural, scale);
  }

  /// In direction d, by point, the hub last; of dashpots only when there are velocities.
  const double *springs(int d) const { return row(SPRINGS + d); }
  const double *dashpots(int d) const { return row(DASHPOTS + d); }

private:
  /// Each for two directions. RING and SPOKES: on a ring point of the spring to the next, and to the hub. RING begins with the last spring's, so that point k has [k + 1] of its own and [k] of the one before.
  enum Row { PLACE = 0, VELOCITY = 2, RING = 4, SPOKES = 6, SPRINGS = 8, DAMPED_RING = 10, DAMPED_SPOKES = 12, DASHPOTS = 14, N_ROWS = 16 };

  double *row(int r) { return rows_.data() + r * room_; }
  const double *row(int r) const { return rows_.data() + r * room_; }

  void resize(int ring_points)
  {
    if (ring_points == n_) return;
    n_ = ring_points;
    blocks_ = (n_ + SpringColumns::block - 1) / SpringColumns::block;
    room_ = (blocks_ + 1) * SpringColumns::block;
    rows_.assign(static_cast<std::size_t>(N_ROWS) * room_, 0.0);
  }

  /// The first ring point stands once more behind the last.
  void take(int d, const int *ring, int hub, const double *values, double *to, double &of_hub) const
  {
    for (int k = 0; k < n_; ++k) to[k] = values[3 * static_cast<std::ptrdiff_t>(ring[k]) + d];
    to[n_] = to[0];
    of_hub = values[3 * static_cast<std::ptrdiff_t>(hub) + d];
  }

  template <bool damped> void find(const SpringSet &natural, const SpringScale &scale)
  {
    const auto next = [](const double *values) { return [p = values + 1](int k) { return p[k]; }; };
    const auto hub = [](double value) { return [value](int) { return value; }; };
    const bool has_spokes = natural.has_spokes();
    add<damped>(natural.ring, scale, next(row(PLACE)), next(row(PLACE + 1)), next(row(VELOCITY)), next(row(VELOCITY + 1)), RING, DAMPED_RING, 1);
    if (has_spokes) add<damped>(natural.spokes, scale, hub(hub_x_[0]), hub(hub_x_[1]), hub(hub_v_[0]), hub(hub_v_[1]), SPOKES, DAMPED_SPOKES, 0);
    for (int d = 0; d < 2; ++d) {
      sum(row(RING + d), row(SPOKES + d), has_spokes, row(SPRINGS + d));
      if (damped) sum(row(DAMPED_RING + d), row(DAMPED_SPOKES + d), has_spokes, row(DASHPOTS + d));
    }
  }

  void sum(double *ring, const double *spokes, bool has_spokes, double *net) const
  {
    ring[0] = ring[n_];
    for (int k = 0; k < n_; ++k) net[k] = ring[k + 1] - ring[k];
    net[n_] = 0.0;
    if (!has_spokes) return;
    double on_hub = 0.0;
    for (int k = 0; k < n_; ++k) {
      net[k] += spokes[k];
      on_hub -= spokes[k];
    }
    net[n_] = on_hub;
  }

  /// Forces on ring points of their springs to the others, in whole blocks: what lies behind the last ring point is never read.
  template <bool damped, class Other>
  void add(const SpringColumns &natural, const SpringScale &scale, Other x_other, Other y_other, Other u_other, Other v_other, int force, int damping, int first)
  {
    const double *x = row(PLACE), *y = row(PLACE + 1), *u = row(VELOCITY), *v = row(VELOCITY + 1);
    const double *length = natural.length(), *stiffness = natural.stiffness(), *dashpot = natural.dashpot();
    double *force_x = row(force) + first, *force_y = row(force + 1) + first, *damping_x = row(damping) + first, *damping_y = row(damping + 1) + first;
    const double scale_k = scale.stiffness, scale_L = scale.length, scale_c = scale.dashpot;
#pragma GCC ivdep
    for (int k = 0; k < blocks_ * SpringColumns::block; ++k) {
      const double dx = x[k] - x_other(k), dy = y[k] - y_other(k), distance = std::sqrt(dx * dx + dy * dy);
      const double over = 1.0 / std::max(distance, std::numeric_limits<double>::min()), nx = over * dx, ny = over * dy;  // zero for two points on one spot
      const double F = -(scale_k * stiffness[k]) * (distance - scale_L * length[k]);
      force_x[k] = F * nx;
      force_y[k] = F * ny;
      if constexpr (damped) {
        const double D = -(scale_c * dashpot[k]) * ((u[k] - u_other(k)) * nx + (v[k] - v_other(k)) * ny);
        damping_x[k] = D * nx;
        damping_y[k] = D * ny;
      }
    }
  }

  int n_ = 0, blocks_ = 0, room_ = 0;
  bool damped_ = false;
  std::vector<double> rows_;
  std::array<double, 2> hub_x_{}, hub_v_{};
};

}  // namespace swellflow
