// Sizes of objects that are not all alike. Free of LIGGGHTS.
#pragma once

#include "random_factor.h"

namespace swellflow {

/// Normal numbers are cut at so many standard deviations, so that no size is near zero; the deviation of what is left: 1 - 6 phi(3) / (2 Phi(3) - 1) is its square.
inline constexpr double cut_of_normal = 3.0, deviation_of_cut_normal = 0.986578;

/// Random factors of mean 1 whose standard deviation is `spread`: that of object number `object` is the same whoever asks.
struct SizeDistribution {
  enum Kind { normal, lognormal, uniform };
  int kind = normal;
  double spread = 0.0;  ///< 0: all factors are 1
  int seed = 0;

  static double largest_spread(int kind) { return kind == normal ? 0.3 : kind == uniform ? 0.5 : 1.0; }

  double factor(std::uint64_t object) const
  {
    if (spread == 0.0) return 1.0;
    const auto of = Purpose::object_size;
    if (kind == lognormal) return lognormal_factor(of, spread, seed, object);
    if (kind == uniform) return 1.0 + spread * std::sqrt(3.0) * (2.0 * uniform_number(of, seed, object, 0) - 1.0);
    double number = normal_number(of, seed, object, 0);
    for (int draw = 1; std::abs(number) > cut_of_normal; ++draw) number = normal_number(of, seed, object, draw);
    return 1.0 + spread / deviation_of_cut_normal * number;
  }
};

}  // namespace swellflow
