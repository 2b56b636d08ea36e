// The objects as the coupled fluid describes them when a step begins: their markers, what these carry, the fluid inside.
#include "coupling/coupled_fluid.h"

#include <cmath>

#include "liggghts_plugins/fix_objects.h"
#include "liggghts_plugins/fluid_columns.h"

namespace swellflow {

namespace {

using Topology = LAMMPS_NS::FixObjects;

/// Share of what an object lacks of its natural area that it may drink in a fluid step, beyond its growth.
constexpr double made_up_per_step = 0.01;

}  // namespace

template <int Dim> void CoupledFluid<Dim>::describe_object(const ObjectPoints &object, const Triple &gravity)
{
  const ObjectMotion motion = motion_of(object, points_, gravity, options_.density);
  ring_.place(object, points_, markers_per_point(object), options_.retraction.value_or(markers_->retraction()) * flow_.grid().h);
  const double h = flow_.grid().h;
  const double layer_mass = options_.density * ring_.perimeter() * h / markers_->scale();
  described_.push_back({motion, inner_fluid_.needs_markers(motion, layer_mass)});
  if (described_.back().filled) ring_.fill(object, points_, h);
  uniform_pressure_ = described_.back().filled ? uniform_pressure(object) : 0.0;
  share_carried_force(object);
  share_owed_impulse(object);
  open_accounts(object, (object.absorbs ? absorption_rate(object) : -excess_growth(object)) - chord_rate(motion.spin));
  inner_pressure_.follow(object, {ring_.outline_area(), 2.0 * natural_rate(object) * dt_, layer_mass}, dt_before_ == 0.0, points_);
}

/// So many that their natural distance is no more than the marker gap that was asked for, where the outline's points are farthest apart.
template <int Dim> int CoupledFluid<Dim>::markers_per_point(const ObjectPoints &object) const
{
  const double *hub = points_.object_point[object.hub], natural = hub[Topology::LONGEST_SIDE] * points_.object_size[object.hub][Topology::LAMBDA];
  const double wanted = std::ceil(natural / (options_.marker_gap * flow_.grid().h) - 1e-9);
  constexpr double most = 10000.0;
  if (!(wanted <= most))
    throw std::runtime_error("a ring point must have at most " + std::to_string(static_cast<int>(most)) + " markers, but the natural distance of some is " + std::to_string(natural) +
                             ": swell less, use more 'points', or a larger 'marker_gap'");
  return std::max(1, static_cast<int>(wanted));
}

/// Of what the markers of a light object carry, the mean of the force outwards per length. A fluid that cannot be pressed does not feel it, as the pressure within takes it up; spread by a
/// kernel it would drive a flow, which is nothing beside heavy points and much beside light ones.
template <int Dim> double CoupledFluid<Dim>::uniform_pressure(const ObjectPoints &object) const
{
  double outwards = 0.0;
  for (int m = 0; m < object.n_ring * ring_.per_point(); ++m) {
    const double *force = points_.carried[object.ring[ring_.marker(m).point]] + FluidCarried::FORCE_X;
    const Vec<2> side = ring_.side(m);
    const double length = std::hypot(side[0], side[1]);
    if (length > 0.0) outwards += (force[0] * side[0] + force[1] * side[1]) / length / ring_.per_point();
  }
  return ring_.perimeter() > 0.0 ? outwards / ring_.perimeter() : 0.0;
}

/// What each ring point feels of the forces that all markers carry, and, last, the hub.
template <int Dim> void CoupledFluid<Dim>::share_carried_force(const ObjectPoints &object)
{
  felt_.assign(object.n_ring + 1, VecD{});
  const int per_point = ring_.per_point();
  VecD &hub = felt_[object.n_ring];
  for (int k = 0; k < object.n_ring; ++k) {
    const double *carried = points_.carried[object.ring[k]] + FluidCarried::FORCE_X;
    for (int m = k * per_point; m < (k + 1) * per_point; ++m) {
      const auto &marker = ring_.marker(m);
      for (int d = 0; d < Dim; ++d) {
        const double force = carried[d] / per_point;
        felt_[k][d] += marker.point_weight() * force;
        felt_[marker.partner][d] += marker.partner_weight() * force;
        hub[d] += marker.share * force;
      }
    }
  }
}

/// What the object is owed as a whole, an impulse and a turning one, as the change of velocity of a rigid body. Point by point it may alternate where markers are
/// close: the fluid does not feel that, but light points would.
template <int Dim> void CoupledFluid<Dim>::share_owed_impulse(const ObjectPoints &object)
{
  if (options_.forcing == ForcingScheme::direct) return;
  const ObjectMotion &motion = described_.back().motion;
  double turn = 0.0;
  VecD impulse{};
  const auto arm = [&](int i, int d) { return points_.x[i][d] - motion.centre[d]; };
  for_each_bearing(object, points_, [&](int i) {
    const double *owed = points_.carried[i] + FluidCarried::OWED_X;
    for (int d = 0; d < Dim; ++d) impulse[d] += owed[d];
    turn += arm(i, 0) * owed[1] - arm(i, 1) * owed[0];
  });
  const double spin = turn / motion.inertia;
  auto felt = felt_.begin();
  for_each_bearing(object, points_, [&](int i) {
    const double share = points_.mass[i] / dt_;
    (*felt)[0] += share * (impulse[0] / motion.mass - spin * arm(i, 1));
    (*felt)[1] += share * (impulse[1] / motion.mass + spin * arm(i, 0));
    ++felt;
  });
}

/// Over a step a point that turns with its object moves along the chord, spin x r - spin^2 dt/2 r, r from where it is at the beginning, which is where the fluid meets it: taken for
/// the fluid's velocity there, that would be a flow inwards, which an incompressible inside resists ever harder. To second order in spin dt.
template <int Dim> double CoupledFluid<Dim>::chord_rate(double spin) const { return 0.5 * spin * spin * dt_; }

/// Of ring point k, n_ring: of the hub.
template <int Dim> int CoupledFluid<Dim>::markers_of(const ObjectPoints &object, int k) const
{
  return (k < object.n_ring ? ring_.per_point() : 0) + static_cast<int>(ring_.inner(k).size());
}

/// inward_rate: what the fluid is asked for beyond the markers' own velocity is a flow through them, inwards by this times their distance from the centroid.
template <int Dim> void CoupledFluid<Dim>::open_accounts(const ObjectPoints &object, double inward_rate)
{
  int next = static_cast<int>(leaving_.size()), all = next;
  for (int k = 0; k <= object.n_ring; ++k) all += markers_of(object, k);
  leaving_.resize(all);
  for (int k = 0; k <= object.n_ring; ++k) {
    const int own = points_.own_index(k < object.n_ring ? object.ring[k] : object.hub);
    if (own < 0) continue;
    if (const int count = markers_of(object, k); count > 0) {
      open_account(object, k, own, next, inward_rate);
      next += count;
      continue;
    }
    for (int d = 0; d < Dim; ++d) {
      points_.law[own][FluidLaw::A_X + d] -= felt_[k][d];
      points_.carried[own][FluidCarried::OWED_X + d] = 0.0;
    }
  }
  leaving_.resize(next);
}

template <int Dim> void CoupledFluid<Dim>::open_account(const ObjectPoints &object, int k, int own, int first, double inward_rate)
{
  const int per_point = ring_.per_point();
  Account account{own, first, markers_of(object, k), k < object.n_ring ? per_point : 0, {}, felt_[k]};
  const double *v = points_.v[own];
  for (int d = 0; d < Dim; ++d) account.carried[d] = points_.carried[own][FluidCarried::FORCE_X + d];
  int m = first;
  for (int r = k * per_point; r < k * per_point + account.n_carrying; ++r) {
    marker_gap_ = std::max(marker_gap_, ring_.gap(r) / flow_.grid().h);
    VecD impulse = ring_.side(r);
    for (int d = 0; d < Dim; ++d) impulse[d] = (account.carried[d] / per_point - uniform_pressure_ * impulse[d]) * dt_;
    send_marker(m++, ring_.marker(r), ring_.spacing(r), impulse, v, inward_rate);
  }
  for (const auto &marker : ring_.inner(k)) send_marker(m++, marker, marker.spacing, {}, v, inward_rate);
  accounts_.push_back(account);
}

/// Where the marker is, what it carries, and c: by how much its velocity differs from its point's.
template <int Dim>
template <class Marker>
void CoupledFluid<Dim>::send_marker(int m, const Marker &marker, double spacing, const VecD &carried_impulse, const double *v_point, double inward_rate)
{
  VecD &x = leaving_.x[m] = marker.x;
  for (int d = 0; d < Dim; ++d) {
    // The run ends soon, with an error, when it is not.
    if (!std::isfinite(x[d])) x[d] = flow_.grid().origin[d];
    leaving_.offset[m][d] = marker.u[d] - v_point[d] - inward_rate * (marker.x[d] - ring_.centroid()[d]);
  }
  leaving_.carried[m] = carried_impulse;
  leaving_.spacing[m] = spacing;
  leaving_.to[m] = slab_of(x);
}

template <int Dim> int CoupledFluid<Dim>::slab_of(const VecD &x) const
{
  const Grid<Dim> &grid = flow_.grid();
  if (grid.ranks == 1) return 0;
  const int last = Grid<Dim>::last;
  const int n = grid.cells[last];
  int plane = static_cast<int>(std::floor((x[last] - grid.origin[last]) / grid.h));
  if (grid.periodic[last]) plane = (plane % n + n) % n;
  return grid.rank_of_plane(std::clamp(plane, 0, n - 1));
}

/// A ring point where there is one: a hub without spokes knows nothing of the object.
template <int Dim> int CoupledFluid<Dim>::any_own(const ObjectPoints &object) const
{
  int own = -1;
  for (int k = 0; k < object.n_ring && own < 0; ++k) own = points_.own_index(object.ring[k]);
  return own >= 0 ? own : points_.own_index(object.hub);
}

/// Of the natural size, plus what makes up for a difference from it.
template <int Dim> double CoupledFluid<Dim>::natural_rate(const ObjectPoints &object) const
{
  const int own = any_own(object);
  if (own < 0 || points_.state[own][FluidState::KNOWS_BEFORE] == 0.0) return 0.0;
  const double *point = points_.object_point[own];
  const double lambda = points_.object_size[own][Topology::LAMBDA], area = ring_.outline_area();
  if (area <= 0.0) return 0.0;
  const double missing = lambda * lambda * point[Topology::NATURAL_AREA] / area - 1.0;
  return (lambda - points_.state[own][FluidState::SWELLING]) / (lambda * dt_before_) + 0.5 * missing * made_up_per_step / dt_;
}

/// q at which the fluid crosses the outline: as fast as the area inside truly changes, which contact may hold back, but between 0 and the natural rate. What is beyond, growth or shrinking,
/// the fluid inside resists.
template <int Dim> double CoupledFluid<Dim>::absorption_rate(const ObjectPoints &object) const
{
  const double natural = natural_rate(object);
  return natural == 0.0 ? 0.0 : std::clamp(ring_.dilation_rate(), std::min(0.0, natural), std::max(0.0, natural));
}

template class CoupledFluid<2>;

}  // namespace swellflow
