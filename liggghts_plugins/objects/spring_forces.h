// All forces of the springs and dashpots of one object at once: the hot loop of a bed. Free of LIGGGHTS.
#pragma once

#include <algorithm>
#include <vector>

#include "spring_set.h"

namespace swellflow {

/// Ring points, then the hub: positions and velocities in, forces out. Kept from object to object, so that nothing is allocated.
struct SpringForces {
  std::vector<Vector2> x, v, spring, dashpot;

  void resize(int points)
  {
    for (auto *values : {&x, &v, &spring, &dashpot}) values->resize(points);
  }

  /// Sets `spring`, and `dashpot` when it is `damped`, from x and v; a hub without spokes gets none. The springs are `scale` times the natural ones.
  void find(const SpringSet &natural, const SpringScale &scale, bool damped)
  {
    for (auto *forces : {&spring, &dashpot}) std::fill(forces->begin(), forces->end(), Vector2::Zero());
    if (damped) add<true>(natural, scale);
    else add<false>(natural, scale);
  }

private:
  template <bool damped> void add(const SpringSet &natural, const SpringScale &scale)
  {
    for_each_spring(natural, [&](int a, int b, const Spring &one) {
      const Spring now = scale * one;
      const Direction along(x[a], x[b]);
      const Vector2 F = spring_force(along, now.length, now.stiffness);
      spring[a] += F;
      spring[b] -= F;
      if constexpr (damped) {
        const Vector2 D = dashpot_force(along, v[a] - v[b], now.dashpot);
        dashpot[a] += D;
        dashpot[b] -= D;
      }
    });
  }
};

}  // namespace swellflow
