// By which angle an object has turned, from where its points are now and were when it was made; free of LIGGGHTS.
#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include "vector2.h"

namespace swellflow {

/// The rotation that takes positions `rest` nearest to `now`, both about their centres of mass: it minimises sum m |now - R rest|^2, in the plane
/// tan angle = sum m rest x now / sum m rest . now (Kabsch, Acta Cryst. A 32, 922, 1976).
struct BestFit {
  double crossed = 0.0, along = 0.0;

  void add(const Vector2 &rest, const Vector2 &now, double mass)
  {
    crossed += mass * (rest.x() * now.y() - rest.y() * now.x());
    along += mass * rest.dot(now);
  }
  double angle() const { return std::atan2(crossed, along); }  ///< in (-pi, pi]; any uniform swelling leaves it as it is
};

inline double best_fit_angle(const std::vector<Vector2> &rest, const std::vector<Vector2> &now, const std::vector<double> &mass)
{
  BestFit fit;
  for (std::size_t k = 0; k < rest.size(); ++k) fit.add(rest[k], now[k], mass[k]);
  return fit.angle();
}

/// The angle that differs from `wrapped` by whole turns and from `before` by half a turn at most. It does not take over rounding errors from `before`.
inline double unwrapped_angle(double wrapped, double before)
{
  constexpr double turn = 2.0 * std::numbers::pi;
  return wrapped + turn * std::round((before - wrapped) / turn);
}

}  // namespace swellflow
