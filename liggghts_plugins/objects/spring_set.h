// The springs of one object: between neighbours of its ring, and from ring to hub; free of LIGGGHTS.
#pragma once

#include <vector>

#include "springs.h"

namespace swellflow {

struct Spring {
  double length = 0.0, stiffness = 0.0, dashpot = 0.0;  ///< natural length L, k, c as they are now
};

/// Factors that all springs of an object share.
struct SpringScale {
  double length = 1.0, stiffness = 1.0, dashpot = 1.0;

  Spring operator*(const Spring &spring) const { return {length * spring.length, stiffness * spring.stiffness, dashpot * spring.dashpot}; }
};

struct SpringSet {
  std::vector<Spring> ring;    ///< ring[k]: from ring point k to k + 1, the last to 0
  std::vector<Spring> spokes;  ///< spokes[k]: from ring point k to the hub, whose number is that of ring points; empty: none

  int ring_points() const { return static_cast<int>(ring.size()); }
  bool has_spokes() const { return !spokes.empty(); }
  /// Points that springs hold: the hub only when it has spokes.
  int held_points() const { return ring_points() + (has_spokes() ? 1 : 0); }
};

/// visit(a, b, spring), each spring once.
template <typename Visit>
void for_each_spring(const SpringSet &springs, const Visit &visit)
{
  const int n = springs.ring_points();
  for (int k = 0; k < n; ++k) {
    visit(k, k + 1 < n ? k + 1 : 0, springs.ring[k]);
    if (springs.has_spokes()) visit(k, n, springs.spokes[k]);
  }
}

}  // namespace swellflow
