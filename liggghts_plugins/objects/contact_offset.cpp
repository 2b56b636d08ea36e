#include "contact_offset.h"

#include <cmath>
#include <stdexcept>

namespace swellflow {

double contact_offset(const Contour &contour, const Vector2 &vertex, double inset)
{
  const double to_hub = vertex.norm();
  const auto fail = [] {
    throw std::invalid_argument("spheres must fit between outline and hub, but with this 'cds' and 'reach' one does not: lower 'cds', or raise 'reach'");
  };
  if (inset >= to_hub) fail();
  if (contour.is_round()) return inset;
  // The distance from the contour changes by no more than the way, so that what is missing may be gone without missing the first such place.
  double offset = inset;
  for (int step = 0; step < 10000; ++step) {
    const double missing = inset - contour.distance(vertex * (1.0 - offset / to_hub));
    if (missing < 1e-9) break;
    offset += missing;
    if (offset >= to_hub) fail();
  }
  return offset;
}

}  // namespace swellflow
