// Discrete delta functions, named after their authors and year.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

namespace swellflow {

// Each kernel has
//   width    points in its support
//   anchor   which of them r is measured from: the nearest point of an odd kernel (r in [-1/2, 1/2]), the one below of an even one (r in [0, 1])
//   radius   of its support, in cells
//   scale    beta: on a straight outline along the grid with markers a cell apart, interpolation after spreading returns this share of the velocity asked for, in
//            the mean over the outline's offsets. Along the outline the weights of the markers sum to 1, across it what is left is the sum of
//            squares of the weights; its mean over the offsets is the integral of phi^2.
//   retraction  in cells: markers so far inside an outline make the flow around it that around the outline. 0.02 less than makes the drag of a square array of discs the
//            exact one, as the wake of a cylinder wants it. Measured in docs/theory.md
//   phi(r)   r in cells
//   weights(r, w)   phi at the `width` points around a marker that lies r beyond the anchor
// and partition of unity and zero first moment at every offset. One that is not the same in all directions has two of them, Along and Across, in their place.

/// Three-point kernel of Roma, Peskin & Berger (J. Comput. Phys. 153, 1999, eq. 22), with sum of squares 1/2 wherever it is centred.
struct Roma1999 {
  static constexpr int width = 3, anchor = 1;
  static constexpr double radius = 1.5;
  static constexpr double scale = 0.5;
  static constexpr double retraction = 0.30;

  static double phi(double r)
  {
    r = std::abs(r);
    if (r >= 1.5) return 0.0;
    if (r >= 0.5) return (5.0 - 3.0 * r - std::sqrt(std::max(0.0, 1.0 - 3.0 * (1.0 - r) * (1.0 - r)))) / 6.0;
    return (1.0 + std::sqrt(1.0 - 3.0 * r * r)) / 3.0;
  }

  /// The middle weight is phi(r); that the weights sum to 1 and have no first moment gives the other two with one square root in all.
  static void weights(double r, double *w)
  {
    w[1] = (1.0 + std::sqrt(1.0 - 3.0 * r * r)) / 3.0;
    w[0] = 0.5 * (1.0 - w[1] - r);
    w[2] = 0.5 * (1.0 - w[1] + r);
  }
};

/// Four-point kernel of Peskin (Acta Numerica 11, 2002, section 6), with sum of squares 3/8 wherever it is centred; its even and its odd points have equal sums.
struct Peskin2002 {
  static constexpr int width = 4, anchor = 1;
  static constexpr double radius = 2.0;
  static constexpr double scale = 0.375;
  static constexpr double retraction = 0.43;

  static double phi(double r)
  {
    r = std::abs(r);
    if (r >= 2.0) return 0.0;
    if (r >= 1.0) return (5.0 - 2.0 * r - std::sqrt(std::max(0.0, -7.0 + 12.0 * r - 4.0 * r * r))) / 8.0;
    return (3.0 - 2.0 * r + std::sqrt(1.0 + 4.0 * r - 4.0 * r * r)) / 8.0;
  }

  /// The square roots of all four are the same.
  static void weights(double r, double *w)
  {
    const double root = std::sqrt(1.0 + 4.0 * r - 4.0 * r * r), below = 3.0 - 2.0 * r, above = 1.0 + 2.0 * r;
    w[0] = 0.125 * (below - root);
    w[1] = 0.125 * (below + root);
    w[2] = 0.125 * (above + root);
    w[3] = 0.125 * (above - root);
  }
};

/// Smoothed three-point kernel phi3* of Yang, Zhang, Li & He (J. Comput. Phys. 228, 2009): the kernel of Roma et al. averaged over a cell,
///     phi(r) = integral of phi_Roma from r - 1/2 to r + 1/2,
/// so that a marker that moves feels the grid less. Its sum of squares varies from 0.4384 to 0.4551 with the offset; `scale` is the mean.
struct Yang2009 {
  static constexpr int width = 4, anchor = 1;
  static constexpr double radius = 2.0;
  static constexpr double scale = 0.44593517768616;
  static constexpr double retraction = 0.35;

  static double phi(double r)
  {
    r = std::abs(r);
    if (r >= 2.0) return 0.0;
    if (r <= 1.0) return even(r) + odd(r);
    const double root = std::sqrt(std::max(0.0, -23.0 + 36.0 * r - 12.0 * r * r));
    return 55.0 / 48.0 - offset - (13.0 / 12.0) * r + 0.25 * r * r + (2.0 * r - 3.0) / 48.0 * root +
           std::numbers::sqrt3 / 36.0 * std::asin(std::clamp(0.5 * std::numbers::sqrt3 * (2.0 * r - 3.0), -1.0, 1.0));
  }

  /// The inner two are phi(r) and phi(1 - r), which differ in the sign of the odd part; sum 1 and no first moment give the outer two.
  static void weights(double r, double *w)
  {
    const double e = even(r), o = odd(r);
    w[1] = e + o;
    w[2] = e - o;
    w[3] = (1.0 + r - w[1] - 2.0 * w[2]) / 3.0;
    w[0] = 1.0 - w[1] - w[2] - w[3];
  }

private:
  static constexpr double offset = std::numbers::sqrt3 * std::numbers::pi / 108.0;
  /// The parts of phi on [0, 1] that are even and odd about r = 1/2.
  static double even(double r) { return 17.0 / 48.0 + offset + 0.25 * r * (1.0 - r); }
  static double odd(double r)
  {
    const double s = 1.0 - 2.0 * r;
    return s / 16.0 * std::sqrt(1.0 + 12.0 * r * (1.0 - r)) + std::numbers::sqrt3 / 12.0 * std::asin(0.5 * std::numbers::sqrt3 * s);
  }
};

/// B-spline of second degree. Written for the four points of the cubic one, of which one beside the three has no share.
struct QuadraticBSpline {
  static constexpr int width = 4, anchor = 1;
  static constexpr double radius = 1.5;

  static double phi(double r)
  {
    r = std::abs(r);
    if (r >= 1.5) return 0.0;
    return r >= 0.5 ? 0.5 * (1.5 - r) * (1.5 - r) : 0.75 - r * r;
  }

  static void weights(double r, double *w)
  {
    const int first = r < 0.5 ? 0 : 1;
    const double s = r - first;
    w[first ? 0 : 3] = 0.0;
    w[first] = 0.5 * (0.5 - s) * (0.5 - s);
    w[first + 1] = 0.75 - s * s;
    w[first + 2] = 0.5 * (0.5 + s) * (0.5 + s);
  }
};

/// B-spline of third degree; its slope is the difference of two quadratic ones: phi'(r) = phi_2(r + 1/2) - phi_2(r - 1/2).
struct CubicBSpline {
  static constexpr int width = 4, anchor = 1;
  static constexpr double radius = 2.0;

  static double phi(double r)
  {
    r = std::abs(r);
    if (r >= 2.0) return 0.0;
    return r >= 1.0 ? (2.0 - r) * (2.0 - r) * (2.0 - r) / 6.0 : (4.0 - 6.0 * r * r + 3.0 * r * r * r) / 6.0;
  }

  static void weights(double r, double *w)
  {
    const double s = 1.0 - r;
    w[0] = s * s * s / 6.0;
    w[1] = (4.0 - 6.0 * r * r + 3.0 * r * r * r) / 6.0;
    w[2] = (4.0 - 6.0 * s * s + 3.0 * s * s * s) / 6.0;
    w[3] = r * r * r / 6.0;
  }
};

/// Composite B-splines of Gruninger & Griffith (J. Comput. Phys. 546, 114472, 2025), BS4BS3: cubic in the direction of the velocity component, quadratic across it. What it
/// makes of face velocities without divergence has none between the faces either, du/dx + dv/dy = 0 by the relation of the two splines: no fluid is lost through
/// a closed outline that moves with it. `scale` is the mean of those of the two components, 151/315 and 11/20.
struct Gruninger2025 {
  using Along = CubicBSpline;
  using Across = QuadraticBSpline;
  static constexpr int width = 4, anchor = 1;
  static constexpr double scale = 0.5 * (151.0 / 315.0 + 11.0 / 20.0);
  static constexpr double retraction = 0.27;
};

}  // namespace swellflow
