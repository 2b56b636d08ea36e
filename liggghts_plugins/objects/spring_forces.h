// All forces of the springs and dashpots of one object at once: the hot loop of a bed. Free of LIGGGHTS.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "spring_set.h"

namespace swellflow {

/// Ring points, then the hub: positions and velocities in, forces out. Kept from object to object, so that nothing is allocated. What spring_force and dashpot_force of springs.h
/// say, in rows that the compiler can turn into vector instructions.
class SpringForces {
public:
  void resize(int ring_points)
  {
    n_ = ring_points;
    blocks_ = (n_ + SpringColumns::block - 1) / SpringColumns::block;
    const int room = blocks_ * SpringColumns::block + 1;  // the first ring point stands once more behind the last, the last force of the ring before the first
    for (auto *rows : {&x_, &v_, &spring_.ring, &spring_.spokes, &dashpot_.ring, &dashpot_.spokes})
      for (auto &row : *rows) row.resize(room);
  }

  /// k = number of ring points: the hub.
  void set_place(int k, const double *x)
  {
    for (int d = 0; d < 2; ++d) (k < n_ ? x_[d][k] : hub_x_[d]) = x[d];
  }
  void set_velocity(int k, const double *v)
  {
    for (int d = 0; d < 2; ++d) (k < n_ ? v_[d][k] : hub_v_[d]) = v[d];
  }

  /// From places, and velocities when it is `damped`. The springs are `scale` times the natural ones; a hub without spokes gets no force.
  void find(const SpringSet &natural, const SpringScale &scale, bool damped)
  {
    if (damped) find<true>(natural, scale);
    else find<false>(natural, scale);
  }

  /// In direction d on point k; of dashpots only when `find` was asked for them.
  double spring(int d, int k) const { return spring_.on(d, k, n_); }
  double dashpot(int d, int k) const { return dashpot_.on(d, k, n_); }

private:
  using Rows = std::array<std::vector<double>, 2>;  // by direction
  struct Force {
    Rows ring;    // [k + 1]: of the spring from point k to the next, on k; [0]: that of the last
    Rows spokes;  // [k]: on ring point k
    std::array<double, 2> hub{};

    double on(int d, int k, int n) const { return k < n ? ring[d][k + 1] - ring[d][k] + spokes[d][k] : hub[d]; }

    void complete(bool has_spokes, int n)
    {
      for (int d = 0; d < 2; ++d) {
        ring[d][0] = ring[d][n];
        hub[d] = 0.0;
        if (has_spokes)
          for (int k = 0; k < n; ++k) hub[d] -= spokes[d][k];
        else
          std::fill(spokes[d].begin(), spokes[d].end(), 0.0);
      }
    }
  };

  template <bool damped> void find(const SpringSet &natural, const SpringScale &scale)
  {
    for (int d = 0; d < 2; ++d) {
      x_[d][n_] = x_[d][0];
      if (damped) v_[d][n_] = v_[d][0];
    }
    const auto next = [](const std::vector<double> &row) { return [p = row.data() + 1](int k) { return p[k]; }; };
    const auto hub = [](double value) { return [value](int) { return value; }; };
    add<damped>(natural.ring, scale, next(x_[0]), next(x_[1]), next(v_[0]), next(v_[1]), spring_.ring, dashpot_.ring, 1);
    if (natural.has_spokes()) add<damped>(natural.spokes, scale, hub(hub_x_[0]), hub(hub_x_[1]), hub(hub_v_[0]), hub(hub_v_[1]), spring_.spokes, dashpot_.spokes, 0);
    spring_.complete(natural.has_spokes(), n_);
    if (damped) dashpot_.complete(natural.has_spokes(), n_);
  }

  /// Forces on ring points of their springs to the others, in whole blocks: what lies behind the last ring point is never read.
  template <bool damped, class Other>
  void add(const SpringColumns &natural, const SpringScale &scale, Other x_other, Other y_other, Other u_other, Other v_other, Rows &force, Rows &damping, int first) const
  {
    const double *x = x_[0].data(), *y = x_[1].data(), *u = v_[0].data(), *v = v_[1].data();
    const double *length = natural.length(), *stiffness = natural.stiffness(), *dashpot = natural.dashpot();
    double *force_x = force[0].data() + first, *force_y = force[1].data() + first, *damping_x = damping[0].data() + first, *damping_y = damping[1].data() + first;
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

  int n_ = 0, blocks_ = 0;
  Rows x_, v_;
  Force spring_, dashpot_;
  std::array<double, 2> hub_x_{}, hub_v_{};
};

}  // namespace swellflow
