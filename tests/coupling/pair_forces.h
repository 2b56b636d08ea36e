// Contact forces asked pair by pair, to compare with those that LIGGGHTS finds by its lists.
#pragma once

#include "dry_scene.h"

namespace swellflow_test {

using Forces = std::map<int, std::array<double, 2>>;  ///< by tag

/// What all spheres of different objects do to each other by linear contacts of stiffness kn, each object having `points` atoms.
inline Forces pair_forces(const DryScene::State &state, int points, double kn)
{
  Forces forces;
  for (const auto &[a, p] : state)
    for (const auto &[b, q] : state) {
      if ((a - 1) / points == (b - 1) / points) continue;
      const double dx = p[0] - q[0], dy = p[1] - q[1], distance = std::hypot(dx, dy), overlap = p[4] + q[4] - distance;
      if (overlap <= 0.0) continue;
      forces[a][0] += kn * overlap * dx / distance;
      forces[a][1] += kn * overlap * dy / distance;
    }
  return forces;
}

}  // namespace swellflow_test
