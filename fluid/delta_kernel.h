// Discrete delta functions, named after their author and year.
#pragma once

#include <algorithm>
#include <cmath>

namespace swellflow {

/// Three-point kernel of Roma, Peskin & Berger (J. Comput. Phys. 153, 1999, eq. 22): support |r| < 1.5 (r in cells), partition of unity, zero first
/// moment, and sum of squares 1/2 wherever it is centred.
struct Roma1999 {
  static constexpr int width = 3;        ///< points in the support
  static constexpr double radius = 1.5;  ///< of the support, in cells
  /// beta: interpolation after spreading returns this share of the velocity asked for, on an outline with markers a cell apart; the forcing is divided by it.
  static constexpr double scale = 0.5;

  static double phi(double r)
  {
    r = std::abs(r);
    if (r >= 1.5) return 0.0;
    if (r >= 0.5) return (5.0 - 3.0 * r - std::sqrt(std::max(0.0, 1.0 - 3.0 * (1.0 - r) * (1.0 - r)))) / 6.0;
    return (1.0 + std::sqrt(1.0 - 3.0 * r * r)) / 3.0;
  }

  /// phi at the three points nearest to a marker that lies r in [-1/2, 1/2] beyond the middle one. The middle weight is phi(r); that the weights sum to 1
  /// and have no first moment gives the other two with one square root in all.
  static void weights(double r, double *w)
  {
    w[1] = (1.0 + std::sqrt(1.0 - 3.0 * r * r)) / 3.0;
    w[0] = 0.5 * (1.0 - w[1] - r);
    w[2] = 0.5 * (1.0 - w[1] + r);
  }
};

}  // namespace swellflow
