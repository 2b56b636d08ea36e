#include "coupling/inner_fluid.h"

#include <algorithm>
#include <cmath>

#include "liggghts_plugins/fix_objects.h"
#include "liggghts_plugins/fluid_columns.h"

namespace swellflow {

namespace {

/// Fluid steps over which a difference between foreseen and true motion is made up for (exponentially).
constexpr double smoothing_steps = 5.0;

/// Fluid steps on end from which on a contact begins to count as one that lasts, and from which on it does so as a whole; in none of them is the force less than this share of the running
/// mean, nor that mean less than this share of the force: round-off of forces that sum up to nothing is no contact that goes on when one begins.
constexpr double begins_to_last = 5.0, lasts = 15.0, least_share = 0.5, least_before = 0.25;

/// By how much of the layer's mass the object may be lighter than the fluid inside; measured in docs/theory.md.
constexpr double bearable_share = 0.1;

/// visit(own point, the image of it that is nearest to the hub)
template <class Visit> void for_each_own_bearing(const ObjectPoints &object, const DemEngine &points, const Visit &visit)
{
  for_each_bearing(object, points, [&](int image) {
    const int own = points.own_index(image);
    if (own >= 0) visit(own, image);
  });
}

int own_bearer(const ObjectPoints &object, const DemEngine &points)
{
  for (int k = 0; k < object.n_ring; ++k)
    if (const int own = points.own_index(object.ring[k]); own >= 0) return own;
  return points.object_point[object.hub][LAMMPS_NS::FixObjects::SPOKES] != 0.0 ? points.own_index(object.hub) : -1;
}

}  // namespace

bool InnerFluid::needs_markers(const ObjectMotion &motion, double layer_mass) const
{
  return mass(motion) - motion.mass > bearable_share * layer_mass;
}

/// What can be trusted to go on of the contacts' forces and torque: the running mean over some two fluid steps where it has lasted. What bounces does not, however long the fluid's step is
/// against the time of a contact.
Eigen::Vector3d InnerFluid::lasting_contact(Known &state, const Eigen::Vector3d &now)
{
  double *mean = &state[FluidState::CONTACT_X], &steps = state[FluidState::CONTACT_STEPS];
  const double square = mean[0] * mean[0] + mean[1] * mean[1], now_square = now[0] * now[0] + now[1] * now[1];
  const bool goes_on = now[0] * mean[0] + now[1] * mean[1] >= least_share * square && square >= least_before * least_before * now_square && square > 0.0;
  steps = goes_on ? std::min(steps + 1.0, lasts) : 0.0;
  const double share = std::max(0.0, (steps - begins_to_last) / (lasts - begins_to_last));
  Eigen::Vector3d result;
  for (int c = 0; c < 3; ++c) {
    mean[c] += 0.5 * (now[c] - mean[c]);
    result[c] = share * mean[c];
  }
  return result;
}

/// When a fluid step begins.
void InnerFluid::follow(Known &state, const ObjectMotion &motion, double dt_before)
{
  const double now[] = {motion.velocity[0], motion.velocity[1], motion.spin};
  const bool known = state[FluidState::KNOWS_BEFORE] != 0.0;
  for (int c = 0; c < 3; ++c) {
    if (known) state[FluidState::DUE_X + c] += now[c] - state[FluidState::VELOCITY_X + c] - state[FluidState::RETURNED_X + c] * dt_before;
    state[FluidState::VELOCITY_X + c] = now[c];
  }
  state[FluidState::KNOWS_BEFORE] = known ? 2.0 : 1.0;
  state[FluidState::SWELLING] = motion.swelling;
}

/// sum of kappa over the points, as it resists a rigid motion, times dt; dt times the sums of the law's forces and torques at the present velocities; and the sums of those of contacts
/// (springs cancel).
InnerFluid::Drag InnerFluid::drag_of(const ObjectPoints &object, const ObjectMotion &motion, const Triple &gravity, double dt, const DemEngine &points)
{
  double impulse[3] = {}, contact[3] = {}, sum = 0.0, sum_x = 0.0, sum_y = 0.0, sum_square = 0.0;
  for_each_bearing(object, points, [&](int i) {
    const double *law = points.law[i], *outer = points.ahead[i] + FluidAhead::OUTER_X;
    const double rx = points.x[i][0] - motion.centre[0], ry = points.x[i][1] - motion.centre[1], kappa = law[FluidLaw::KAPPA], mass = points.mass[i];
    const Vec<2> v = drift_velocity(points, i, gravity);
    const double fx = law[FluidLaw::A_X] - kappa * v[0], fy = law[FluidLaw::A_Y] - kappa * v[1], cx = outer[0] - mass * gravity[0], cy = outer[1] - mass * gravity[1];
    impulse[0] += fx;
    impulse[1] += fy;
    impulse[2] += rx * fy - ry * fx;
    contact[0] += cx;
    contact[1] += cy;
    contact[2] += rx * cy - ry * cx;
    sum += kappa;
    sum_x += kappa * rx;
    sum_y += kappa * ry;
    sum_square += kappa * (rx * rx + ry * ry);
  });
  const Eigen::Matrix3d mass{{sum, 0.0, -sum_y}, {0.0, sum, sum_x}, {-sum_y, sum_x, sum_square}};
  return {.impulse = dt * Eigen::Vector3d(impulse), .contact = Eigen::Vector3d(contact), .mass = dt * mass};
}

/// As a rigid body: (M - rho_f V) (V1 - V0) = dt [ sum (a - kappa u) + (M - rho_f V) g + lasting contact ], u = V1 + W1 x r + what points have beyond that now; the same with torques.
Eigen::Vector3d InnerFluid::foresee(const Drag &drag, const ObjectMotion &motion, const Triple &gravity, double dt) const
{
  const double excess = 1.0 - mass(motion) / motion.mass;
  const double excess_inertia = (1.0 - motion.inner_inertia * mass(motion) / motion.mass) * motion.inertia;
  const Eigen::Vector3d excess_mass(excess * motion.mass, excess * motion.mass, excess_inertia);
  const Eigen::Matrix3d A = drag.mass + Eigen::Matrix3d(excess_mass.asDiagonal());
  const Eigen::Vector3d change = A.ldlt().solve(drag.impulse + dt * drag.contact + dt * excess_mass.cwiseProduct(Eigen::Vector3d(gravity[0], gravity[1], 0.0)));
  return change.allFinite() ? Eigen::Vector3d(change / dt) : Eigen::Vector3d::Zero();
}

/// When the two meet, the fluid inside moves as that around, not as the object does: what it lacks.
Eigen::Vector3d InnerFluid::lacking(const Drag &drag) const
{
  const Eigen::Vector3d lacking = -drag.mass.ldlt().solve(drag.impulse);
  return lacking.allFinite() ? lacking : Eigen::Vector3d::Zero();
}

void InnerFluid::return_inertia(const ObjectPoints &object, const ObjectMotion &motion, bool has_markers, const Triple &gravity, double dt, double dt_before,
                                const DemEngine &points) const
{
  const int bearer = own_bearer(object, points);
  if (bearer < 0) return;
  Known state;
  std::copy_n(points.state[bearer], state.size(), state.begin());
  follow(state, motion, dt_before);
  const bool meets = state[FluidState::KNOWS_BEFORE] == 1.0;
  Drag drag = meets || !has_markers ? drag_of(object, motion, gravity, dt, points) : Drag{};
  drag.contact = lasting_contact(state, drag.contact);
  const Eigen::Vector3d foreseen = has_markers ? Eigen::Vector3d::Zero() : foresee(drag, motion, gravity, dt);
  const Eigen::Vector3d at_first = meets ? lacking(drag) : Eigen::Vector3d::Zero();
  double *a = &state[FluidState::RETURNED_X];
  for (int c = 0; c < 3; ++c) {
    if (meets) state[FluidState::DUE_X + c] = at_first[c];
    a[c] = foreseen[c] + state[FluidState::DUE_X + c] / (smoothing_steps * dt);
  }
  const double per_mass = mass(motion) / motion.mass, turn = motion.inner_inertia * a[2];
  for_each_own_bearing(object, points, [&](int own, int image) {
    std::copy_n(state.begin(), state.size(), points.state[own]);
    const double rx = points.x[image][0] - motion.centre[0], ry = points.x[image][1] - motion.centre[1], share = per_mass * points.mass[own];
    const double force[] = {share * (a[0] - turn * ry - gravity[0]), share * (a[1] + turn * rx - gravity[1])};
    for (int d = 0; d < 2; ++d) {
      points.home[own][FluidHome::INNER_FORCE_X + d] = force[d];
      points.law[own][FluidLaw::A_X + d] += force[d];
    }
  });
}

}  // namespace swellflow
