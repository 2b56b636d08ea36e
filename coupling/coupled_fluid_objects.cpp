// The objects as the coupled fluid describes them when a step begins: their markers, what these carry, the fluid inside.
#include "coupling/coupled_fluid.h"

#include <cmath>

#include "liggghts_plugins/fix_objects.h"
#include "liggghts_plugins/fluid_columns.h"
#include "liggghts_plugins/objects/outline.h"

namespace swellflow {

namespace {

using Topology = LAMMPS_NS::FixObjects::Column;

/// Fluid steps over which the acceleration of the fluid inside is smoothed (exponentially); measured in docs/theory.md.
constexpr double smoothing_steps = 5.0;

/// Share of what an object lacks of its natural area that it may drink in a fluid step, beyond its growth.
constexpr double made_up_per_step = 0.01;

}  // namespace

template <int Dim> void CoupledFluid<Dim>::describe_object(const ObjectPoints &object, const Triple &gravity)
{
  const ObjectMotion motion = motion_of(object, points_);
  return_inner_fluid(object, motion, gravity);
  ring_.place(object, points_, markers_per_point(object), options_.retraction.value_or(markers_->retraction()) * flow_.grid().h);
  share_carried_force(object);
  share_owed_impulse(object);
  open_accounts(object, object.absorbs ? absorption_rate(object) : 0.0);
  remember_motion(object, motion);
}

/// So many that their natural distance is no more than the marker gap that was asked for, where the outline's points are farthest apart.
template <int Dim> int CoupledFluid<Dim>::markers_per_point(const ObjectPoints &object) const
{
  const double *hub = points_.object_point[object.hub];
  const auto vertex = [&](int k) {
    const double *point = points_.object_point[object.ring[k]];
    return outline_point({point[Topology::REST_X] - hub[Topology::REST_X], point[Topology::REST_Y] - hub[Topology::REST_Y]}, point[Topology::OUTLINE_OFFSET]);
  };
  double longest = 0.0;
  Vector2 before = vertex(object.n_ring - 1);
  for (int k = 0; k < object.n_ring; ++k) {
    const Vector2 here = vertex(k);
    longest = std::max(longest, (here - before).norm());
    before = here;
  }
  const double natural = longest * hub[Topology::LAMBDA];
  return std::max(1, static_cast<int>(std::ceil(natural / (options_.marker_gap * flow_.grid().h) - 1e-9)));
}

/// What each ring point feels of the forces that all markers carry, and what the hub does, which goes straight into its law.
template <int Dim> void CoupledFluid<Dim>::share_carried_force(const ObjectPoints &object)
{
  felt_.assign(object.n_ring, VecD{});
  const int own_hub = points_.own_index(object.hub);
  double *hub = own_hub >= 0 ? points_.law[own_hub] : nullptr;
  for (int m = 0; m < object.n_ring * ring_.per_point(); ++m) {
    const auto &marker = ring_.marker(m);
    for (int d = 0; d < Dim; ++d) {
      const double force = points_.carried[object.ring[marker.point]][FluidCarried::FORCE_X + d] / ring_.per_point();
      felt_[marker.point][d] += marker.point_weight() * force;
      felt_[marker.partner][d] += marker.partner_weight() * force;
      if (hub) hub[FluidLaw::A_X + d] -= marker.share * force;
    }
  }
}

/// What the object is owed as a whole, an impulse and a turning one, as the change of velocity of a rigid body. Point by point it may alternate where markers are
/// close: the fluid does not feel that, but light points would.
template <int Dim> void CoupledFluid<Dim>::share_owed_impulse(const ObjectPoints &object)
{
  if (options_.forcing == ForcingScheme::direct) return;
  double mass = 0.0, inertia = 0.0, turn = 0.0;
  VecD centre{}, impulse{};
  const int first = points_.object_point[object.hub][Topology::SPOKES] == 0.0 ? 0 : -1;  // a hub that only follows takes nothing
  const auto point = [&](int k) { return k < 0 ? object.hub : object.ring[k]; };
  for (int k = first; k < object.n_ring; ++k) {
    mass += points_.mass[point(k)];
    for (int d = 0; d < Dim; ++d) centre[d] += points_.mass[point(k)] * points_.x[point(k)][d];
  }
  for (double &c : centre) c /= mass;
  for (int k = first; k < object.n_ring; ++k) {
    const double *x = points_.x[point(k)], rx = x[0] - centre[0], ry = x[1] - centre[1];
    inertia += points_.mass[point(k)] * (rx * rx + ry * ry);
    if (k < 0) continue;
    const double *owed = points_.carried[point(k)] + FluidCarried::OWED_X;
    for (int d = 0; d < Dim; ++d) impulse[d] += owed[d];
    turn += rx * owed[1] - ry * owed[0];
  }
  const double spin = turn / inertia;
  for (int k = first; k < object.n_ring; ++k) {
    const double *x = points_.x[point(k)], share = points_.mass[point(k)] / dt_;
    const VecD force{share * (impulse[0] / mass - spin * (x[1] - centre[1])), share * (impulse[1] / mass + spin * (x[0] - centre[0]))};
    const int own = points_.own_index(point(k));
    for (int d = 0; d < Dim; ++d) {
      if (k >= 0) felt_[k][d] += force[d];
      else if (own >= 0) points_.law[own][FluidLaw::A_X + d] -= force[d];
    }
  }
}

template <int Dim> void CoupledFluid<Dim>::open_accounts(const ObjectPoints &object, double absorption_rate)
{
  for (int k = 0; k < object.n_ring; ++k) {
    const int i = points_.own_index(object.ring[k]);
    if (i < 0) continue;
    Account account{i, static_cast<int>(leaving_.size()), ring_.per_point(), {}, felt_[k]};
    for (int d = 0; d < Dim; ++d) account.carried[d] = points_.carried[i][FluidCarried::FORCE_X + d];
    accounts_.push_back(account);
    for (int m = k * ring_.per_point(); m < (k + 1) * ring_.per_point(); ++m) add_marker(object, m, absorption_rate);
  }
}

/// Where the marker is, what it carries, and c: by how much its velocity differs from its point's.
template <int Dim> void CoupledFluid<Dim>::add_marker(const ObjectPoints &object, int m, double absorption_rate)
{
  const auto &marker = ring_.marker(m);
  const int i = object.ring[marker.point];
  marker_gap_ = std::max(marker_gap_, ring_.gap(m) / flow_.grid().h);
  Arrival arrival{marker.x, {}, ring_.spacing(m)};
  VecD offset;
  for (int d = 0; d < Dim; ++d) {
    // The run ends soon, with an error, when it is not.
    if (!std::isfinite(arrival.x[d])) arrival.x[d] = flow_.grid().origin[d];
    arrival.carried_impulse[d] = points_.carried[i][FluidCarried::FORCE_X + d] * dt_ / ring_.per_point();
    offset[d] = marker.u[d] - points_.v[i][d] - absorption_rate * (marker.x[d] - ring_.centroid()[d]);
  }
  leaving_.push_back(arrival);
  offset_.push_back(offset);
  to_.push_back(slab_of(arrival.x));
}

template <int Dim> int CoupledFluid<Dim>::slab_of(const VecD &x) const
{
  const Grid<Dim> &grid = flow_.grid();
  const int last = Grid<Dim>::last;
  const int n = grid.cells[last];
  int plane = static_cast<int>(std::floor((x[last] - grid.origin[last]) / grid.h));
  if (grid.periodic[last]) plane = (plane % n + n) % n;
  return grid.rank_of_plane(std::clamp(plane, 0, n - 1));
}

template <int Dim> int CoupledFluid<Dim>::any_own(const ObjectPoints &object) const
{
  int own = points_.own_index(object.hub);
  for (int k = 0; k < object.n_ring && own < 0; ++k) own = points_.own_index(object.ring[k]);
  return own;
}

/// q at which the fluid crosses the outline: as fast as the area inside truly changes, which contact may hold back, but between 0 and the rate of the natural size
/// plus what makes up for a difference from it. What is beyond, growth or shrinking, the fluid inside resists.
template <int Dim> double CoupledFluid<Dim>::absorption_rate(const ObjectPoints &object) const
{
  const int own = any_own(object);
  if (own < 0 || points_.state[own][FluidState::KNOWS_BEFORE] == 0.0) return 0.0;
  const double *point = points_.object_point[own];
  const double lambda = point[Topology::LAMBDA], area = ring_.outline_area();
  if (area <= 0.0) return 0.0;
  const double missing = lambda * lambda * point[Topology::NATURAL_AREA] / area - 1.0;
  const double natural =
      (lambda - points_.state[own][FluidState::SWELLING]) / (lambda * dt_before_) + 0.5 * missing * made_up_per_step / dt_;
  return std::clamp(ring_.dilation_rate(), std::min(0.0, natural), std::max(0.0, natural));
}

/// Force on each point from the fluid inside the object, in shares of mass: rho_f V (a + alpha x r), and the weight it takes away. a is that of the ring, smoothed over
/// some fluid steps. A force that lags feeds what it is in phase with: taken from all points it would feed the oscillation of hub against ring (the hub moves
/// against ring and fluid, so the two signs differ), unsmoothed the vibrations of objects in contact.
template <int Dim>
void CoupledFluid<Dim>::return_inner_fluid(const ObjectPoints &object, const ObjectMotion &motion, const Triple &gravity)
{
  const double ratio = options_.density * motion.natural_area / motion.mass;
  for (int k = -1; k < object.n_ring; ++k) {
    const int image = k < 0 ? object.hub : object.ring[k], i = points_.own_index(image);
    if (i < 0) continue;
    double *state = points_.state[i];
    if (state[FluidState::KNOWS_BEFORE] != 0.0) {
      const auto smooth = [&](int column, double now, double before) {
        state[column] += ((now - before) / dt_before_ - state[column]) / smoothing_steps;
      };
      smooth(FluidState::ACCELERATION_X, motion.velocity[0], state[FluidState::RING_VELOCITY_X]);
      smooth(FluidState::ACCELERATION_Y, motion.velocity[1], state[FluidState::RING_VELOCITY_Y]);
      smooth(FluidState::SPIN_ACCELERATION, motion.spin, state[FluidState::RING_SPIN]);
    }
    const double alpha = state[FluidState::SPIN_ACCELERATION];
    const double ax = state[FluidState::ACCELERATION_X] - alpha * (points_.x[image][1] - motion.centre[1]) - gravity[0];
    const double ay = state[FluidState::ACCELERATION_Y] + alpha * (points_.x[image][0] - motion.centre[0]) - gravity[1];
    state[FluidState::BODY_FORCE_X] = ratio * points_.mass[i] * ax;
    state[FluidState::BODY_FORCE_Y] = ratio * points_.mass[i] * ay;
  }
}

template <int Dim> void CoupledFluid<Dim>::remember_motion(const ObjectPoints &object, const ObjectMotion &motion)
{
  for (int k = -1; k < object.n_ring; ++k) {
    const int i = points_.own_index(k < 0 ? object.hub : object.ring[k]);
    if (i < 0) continue;
    double *state = points_.state[i];
    state[FluidState::KNOWS_BEFORE] = 1.0;
    state[FluidState::RING_VELOCITY_X] = motion.velocity[0];
    state[FluidState::RING_VELOCITY_Y] = motion.velocity[1];
    state[FluidState::RING_SPIN] = motion.spin;
    state[FluidState::SWELLING] = points_.object_point[i][Topology::LAMBDA];
  }
}

template class CoupledFluid<2>;

}  // namespace swellflow
