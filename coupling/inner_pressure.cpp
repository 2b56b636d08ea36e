#include "coupling/inner_pressure.h"

#include <algorithm>
#include <cmath>

#include "liggghts_plugins/fluid_columns.h"
#include "liggghts_plugins/objects/outline.h"

namespace swellflow {

namespace {

/// Mass of the ring over that of the layer from which on forcing, which then takes more than five fluid steps, is too slow.
constexpr double slow_ratio = 25.0;

/// In a fluid step, where it has as many DEM steps.
constexpr int pressures_per_step = 5;

/// c_1 and c_0: a disturbance dies out by 0.7 a time, also with springs that swing by up to a radian in between.
constexpr double of_rate = 0.6, of_area = 0.15;

double ring_mass(const ObjectPoints &object, const DemEngine &points)
{
  double mass = 0.0;
  for (int k = 0; k < object.n_ring; ++k) mass += points.mass[object.ring[k]];
  return mass;
}

/// The side between the two neighbours of point k, halved and turned outwards: by which the ring's area grows with the point's way.
Vector2 side(const ObjectPoints &object, int k, const DemEngine &points)
{
  const double *a = points.x[object.ring[k > 0 ? k - 1 : object.n_ring - 1]], *b = points.x[object.ring[k + 1 < object.n_ring ? k + 1 : 0]];
  return {0.5 * (b[1] - a[1]), 0.5 * (a[0] - b[0])};
}

double points_area(const ObjectPoints &object, const DemEngine &points)
{
  double twice = 0.0;
  const double *hub = points.x[object.hub];
  for (int k = 0; k < object.n_ring; ++k) {
    const double *x = points.x[object.ring[k]];
    twice += side(object, k, points).dot(Vector2(x[0] - hub[0], x[1] - hub[1]));
  }
  return 0.5 * twice;
}

/// Change of the points' area that a pressure of 1 makes in the square of a time of 1.
double ease(const ObjectPoints &object, const DemEngine &points)
{
  double sum = 0.0;
  for (int k = 0; k < object.n_ring; ++k) sum += side(object, k, points).squaredNorm() / points.mass[object.ring[k]];
  return sum;
}

/// visit(own point): all of an object keep the same state.
template <class Visit> void for_each_own(const ObjectPoints &object, const DemEngine &points, const Visit &visit)
{
  for (int k = 0; k < object.n_ring; ++k)
    if (const int own = points.own_index(object.ring[k]); own >= 0) visit(own, k);
}

/// The fluid inside follows the outline as far as that goes towards the natural area, and no faster than that may grow.
double allowed_area(double inside, double change_of_inside, double area)
{
  const double change = change_of_inside * inside;
  return inside + std::clamp(area - inside, std::min(0.0, change), std::max(0.0, change));
}

}  // namespace

void InnerPressure::begin(double dt, int dem_steps)
{
  interval_ = (dem_steps + pressures_per_step - 1) / pressures_per_step;
  dem_steps_ = dem_steps;
  tau_ = dt * interval_ / dem_steps;
  some_ = false;
}

void InnerPressure::follow(const ObjectPoints &object, const Ring &ring, bool first, const DemEngine &points)
{
  const double turn = object.spring_frequency * tau_;
  double share = std::max(0.0, 1.0 - slow_ratio * ring.layer_mass / ring_mass(object, points)) * std::max(0.0, 1.0 - turn * turn);
  const double of_points = share > 0.0 ? points_area(object, points) : 0.0;
  if (object.inflates || first || !(of_points > 0.0)) share = 0.0;
  some_ = some_ || share > 0.0;
  for_each_own(object, points, [&](int own, int) {
    double *state = points.state[own], *home = points.home[own];
    if (share == 0.0 && home[FluidHome::PRESSED] == 0.0) return;  // as in most scenes
    home[FluidHome::PRESSURE_X] = home[FluidHome::PRESSURE_Y] = 0.0;
    if ((home[FluidHome::PRESSED] = share) == 0.0) {
      state[FluidState::AREA_INSIDE] = state[FluidState::AREA_BEYOND] = 0.0;
      return;
    }
    home[FluidHome::AREA_CHANGE] = ring.natural_change;
    home[FluidHome::AREA_PER_POINTS] = ring.area / of_points;
    double &inside = state[FluidState::AREA_INSIDE];
    inside = inside > 0.0 ? allowed_area(inside, ring.natural_change, ring.area) : ring.area;
  });
}

void InnerPressure::press(const ObjectPoints &object, int dem_step, const DemEngine &points) const
{
  if (!some_) return;
  double now = 0.0, per_ease = 0.0;
  // The law's impulse over the whole fluid step is what counts: this is the part of it that is left.
  const double left = 1.0 - static_cast<double>(dem_step) / dem_steps_;
  for_each_own(object, points, [&](int own, int k) {
    double *state = points.state[own], *home = points.home[own];
    if (home[FluidHome::PRESSED] == 0.0) return;
    if (per_ease == 0.0) {
      now = points_area(object, points);
      per_ease = now / (tau_ * tau_ * ease(object, points));
    }
    const double area = home[FluidHome::AREA_PER_POINTS] * now, inside = state[FluidState::AREA_INSIDE];
    const double beyond = area / (dem_step == 0 ? inside : allowed_area(inside, home[FluidHome::AREA_CHANGE], area)) - 1.0;
    const double pressure = -home[FluidHome::PRESSED] * (of_rate * (beyond - state[FluidState::AREA_BEYOND]) + of_area * beyond) * per_ease;
    state[FluidState::AREA_BEYOND] = beyond;
    const Vector2 force = pressure * side(object, k, points);
    for (int d = 0; d < 2; ++d) {
      double &before = home[FluidHome::PRESSURE_X + d];
      points.law[own][FluidLaw::A_X + d] += force[d] - before;
      home[FluidHome::INNER_FORCE_X + d] += (force[d] - before) * left;
      before = force[d];
    }
  });
}

}  // namespace swellflow
