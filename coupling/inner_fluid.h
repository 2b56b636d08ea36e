// The fluid inside an object: it is fluid of the solver, with inertia and weight of its own, which the object must not have twice.
#pragma once

#include <Eigen/Dense>
#include <array>

#include "coupling/dem_engine.h"
#include "coupling/object_motion.h"
#include "liggghts_plugins/fluid_columns.h"
#include "liggghts_plugins/fluid_partner.h"

namespace swellflow {

/// The points bear the whole mass M of their object; so that it moves with the inertia and the weight of M - rho_f V, V its natural area, the points get the force
/// rho_f V (a + alpha x r - g) in shares of mass (Uhlmann 2005, eqs. 17 to 24: a solid body whose inside is fluid), alpha scaled by the inertia of the fluid inside over that of these
/// shares. a and alpha are those of the coming fluid step as
/// gravity, lasting contacts and the fluid's law make them; what they were off the motion that came of it is made up for over the next steps. docs/theory.md has the measurements.
/// 2-D, per unit depth.
class InnerFluid {
public:
  explicit InnerFluid(double density) : density_(density) {}

  /// Whether the fluid inside is too heavy for the layer that the markers on the outline move at once (its mass per unit depth, rho_f times perimeter times h /
  /// beta), so that it must be moved by markers of its own.
  bool needs_markers(const ObjectMotion &motion, double layer_mass) const;
  /// Adds the force to the law of own points, for a step of length dt, the last having had dt_before. All points, ghosts too, need the law without it. `has_markers`: the fluid
  /// inside has markers. It then follows at once: nothing is foreseen. Notes in the points' state how the object moves.
  void return_inertia(const ObjectPoints &object, const ObjectMotion &motion, bool has_markers, const Triple &gravity, double dt, double dt_before, const DemEngine &points) const;

private:
  /// In x, y and about the centre.
  struct Drag {
    Eigen::Vector3d impulse = Eigen::Vector3d::Zero(), contact = Eigen::Vector3d::Zero();
    Eigen::Matrix3d mass = Eigen::Matrix3d::Zero();
  };
  /// What the points of an object know of it, all of them the same: FluidState up to CONTACT_STEPS.
  using Known = std::array<double, FluidState::CONTACT_STEPS + 1>;
  static Eigen::Vector3d lasting_contact(Known &state, const Eigen::Vector3d &now);
  static void follow(Known &state, const ObjectMotion &motion, double dt_before);
  double mass(const ObjectMotion &motion) const { return density_ * motion.natural_area; }
  static Drag drag_of(const ObjectPoints &object, const ObjectMotion &motion, const Triple &gravity, double dt, const DemEngine &points);
  Eigen::Vector3d foresee(const Drag &drag, const ObjectMotion &motion, const Triple &gravity, double dt) const;
  Eigen::Vector3d lacking(const Drag &drag) const;

  double density_;
};

}  // namespace swellflow
