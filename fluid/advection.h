// The fluxes that advection carries through the faces of a cell.
#pragma once

#include <cstddef>

namespace swellflow {

enum class Advection {
  central,  ///< mean of the two cells: second order, no dissipation
  bounded,  ///< upwind with the limiter of van Leer (J. Comput. Phys. 14, 1974): second order where smooth, no new extrema
  none      ///< creeping flow
};

/// Twice the value on the face between q[0] (lower) and q[s] (upper), through which the velocity F goes.
template <Advection scheme> inline double twice_on_face(const double *q, std::ptrdiff_t s, double F)
{
  if constexpr (scheme == Advection::central) return q[0] + q[s];
  // upwind value + 1/2 phi(r) (downwind - upwind), phi the harmonic limiter: a b / (a + b) where both differences have one sign.
  const bool up = F > 0.0;
  const double upwind = up ? q[0] : q[s], b = up ? q[s] - q[0] : q[0] - q[s], a = up ? q[0] - q[-s] : q[s] - q[2 * s];
  const double product = a * b;
  return 2.0 * (upwind + (product > 0.0 ? product / (a + b) : 0.0));
}

}  // namespace swellflow
