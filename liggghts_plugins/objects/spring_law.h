// What a script says of the springs of an object, and the springs that follow from it; free of LIGGGHTS.
#pragma once

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "spring_set.h"

namespace swellflow {

/// Stiffness over that of the unswollen object as a function of the swelling ratio lambda.
struct Stiffening {
  double power = 0.0;                             ///< lambda^power …
  std::vector<std::pair<double, double>> table{}; ///< … or, when it is not empty, linear between (lambda, factor), ascending, held beyond both ends

  double factor(double lambda) const
  {
    if (table.empty()) return power == 0.0 ? 1.0 : std::pow(lambda, power);
    const auto above = std::upper_bound(table.begin(), table.end(), lambda, [](double value, const auto &row) { return value < row.first; });
    if (above == table.begin()) return above->second;
    if (above == table.end()) return table.back().second;
    const auto below = above - 1;
    const double share = (lambda - below->first) / (above->first - below->first);
    return (1.0 - share) * below->second + share * above->second;
  }
};

struct SpringLaw {
  double stiffness = 0.0;     ///< k_s of every spring, force per length and unit depth; 0: given by the modulus
  double modulus = 0.0;       ///< E, tension over strain, force per unit depth: k = E / L
  double damping = 0.0;       ///< zeta
  bool zero_lengths = false;  ///< springs pull at any length; with a modulus k = E / L with the length L that they would have
  Stiffening stiffening{};

  /// The spring between points of masses m_a and m_b whose natural length is `length`, of an object that has not swollen.
  Spring natural(double length, double mass_a, double mass_b) const
  {
    const double k = stiffness > 0.0 ? stiffness : modulus / length;
    return {.length = zero_lengths ? 0.0 : length, .stiffness = k, .dashpot = damping > 0.0 ? dashpot_constant(damping, k, mass_a, mass_b) : 0.0};
  }

  /// What makes of all natural springs of an object those at the swelling ratio lambda, when its masses are `mass_ratio` times those at creation: c goes with sqrt(m k).
  SpringScale scale(double lambda, double mass_ratio) const
  {
    const double k = (stiffness > 0.0 ? 1.0 : 1.0 / lambda) * stiffening.factor(lambda);
    return {.length = lambda, .stiffness = k, .dashpot = damping > 0.0 ? std::sqrt(k * mass_ratio) : 0.0};
  }
};

}  // namespace swellflow
