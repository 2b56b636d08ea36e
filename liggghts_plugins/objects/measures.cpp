#include "measures.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace swellflow {

MeasureTotals::MeasureTotals(const std::vector<ObjectMeasures> &objects)
{
  largest.fill(-std::numeric_limits<double>::infinity());
  for (const ObjectMeasures &object : objects) {
    const double turned = std::abs(object.rotation);
    const std::array<double, N_SUMS> values = {1.0, object.mean_diameter, object.diameter_of_area, object.area, object.aspect_ratio, object.spring_energy,
                                               object.kinetic_energy, object.contact_pressure, object.contact_force,
                                               static_cast<double>(object.coordination), turned, object.velocity[0], object.velocity[1],
                                               object.centroid[1]};
    for (int k = 0; k < N_SUMS; ++k) sum[k] += values[k];
    const std::array<double, N_LARGEST> candidates = {-object.area_ratio, object.contact_pressure, turned};
    for (int k = 0; k < N_LARGEST; ++k) largest[k] = std::max(largest[k], candidates[k]);
  }
}

}  // namespace swellflow
