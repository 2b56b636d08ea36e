// The coupled step: the fluid and LIGGGHTS' points, once a fluid step each way.
#pragma once

#include "coupling/courier.h"
#include "coupling/marker_ring.h"
#include "coupling/object_motion.h"
#include "fluid/flow_solver.h"
#include "fluid/markers.h"

namespace swellflow {

/// Direct-forcing immersed boundary (Uhlmann 2005; Guinea, Toriu & Ushijima 2022) in the form of docs/theory.md. A fluid step is
///
///   arrive      a marker a ring point, `retraction` cells towards the hub, goes to the slab that holds it
///   predict     u~ with the force F_c that each marker gave in the step before, spread at its new place
///   interpolate u~ at the markers
///   hand out    the force on a point is  kappa (u~ - c - v) - (1 - s) F_c  while LIGGGHTS takes its N steps; the hub bears -s F_c of each of its ring points
///   collect     the impulse I that each point truly received: the marker gives the fluid J = s F_c dt - I in all
///   spread      J - F_c dt; then F_c = J / dt
///   project     div u = 0
///
/// with kappa = rho_f ds h / (beta dt), ds the spacing of the markers, beta the larger of the kernel's scale and the row sum (what comes back at a marker when all are asked to
/// change by 1: more than the scale only where markers crowd); s the marker's share of the way to the hub; c the marker's velocity less its point's: s (V - v) with V the hub's,
/// less q (x - x_c) if the object absorbs, q = (dA/dt) / (2A) of the outline's actual motion, between 0 and the natural rate. What points receive and what the fluid gives is equal
/// to round-off. The fluid inside an object has inertia of its own, which is returned: with rho_f V a of the object's last acceleration, as is its weight.
template <int Dim> class CoupledFluid : public FluidPartner {
public:
  CoupledFluid(void *lammps, const FluidOptions &options, const Grid<Dim> &grid, const WallVelocities<Dim> &walls);

  void weigh(const std::vector<ObjectPoints> &objects, const std::array<double, 3> &gravity) override;
  void begin_step(const std::vector<ObjectPoints> &objects, const std::array<double, 3> &gravity) override;
  void finish_step(const std::vector<ObjectPoints> &objects) override;

  FluidReport report() override;
  FieldBlock field_block() const override;
  std::vector<FieldInfo> fields() const override;
  void copy_field(const std::string &name, std::vector<double> &values) const override;
  double seconds_in_fluid() const override { return seconds_in_fluid_; }
  double seconds_in_coupling() const override { return seconds_in_coupling_; }

private:
  using VecD = Vec<Dim>;
  /// What travels to the slab when a step begins, what comes back, and what follows when it ends.
  struct Arrival {
    VecD x, carried_impulse;
    double spacing;
  };
  struct Answer {
    VecD u;
    double kappa;
    int slot;
  };
  struct Receipt {
    int slot;
    VecD impulse;
  };
  /// An own ring point while its law is made.
  struct OwnMarker {
    int point;
    double share;
    VecD offset;
  };

  void describe_markers(const std::vector<ObjectPoints> &objects, const std::array<double, 3> &gravity);
  void describe_object(const ObjectPoints &object, const std::array<double, 3> &gravity);
  void describe_marker(const ObjectPoints &object, int k, double absorption_rate);
  double absorption_rate(const ObjectPoints &object) const;
  void return_inner_fluid(const ObjectPoints &object, const ObjectMotion &motion, const std::array<double, 3> &gravity);
  void arrive();
  void set_kappa();
  void spread(const std::vector<VecD> &impulses);
  void hand_out();
  void collect(const std::vector<ObjectPoints> &objects);
  void remember_motion(const ObjectPoints &object, const ObjectMotion &motion);
  VecD given_to_fluid() const;

  FlowSolver<Dim> flow_;
  Markers<Dim> markers_;
  DemEngine points_;
  MarkerRing ring_;
  Courier courier_;
  FluidOptions options_;
  double dt_ = 0.0;

  // On the rank of the point
  std::vector<OwnMarker> own_;
  std::vector<Arrival> leaving_;
  std::vector<int> to_;
  std::vector<Receipt> receipts_, arrived_receipts_;
  std::vector<Answer> answers_at_own_;
  // On the rank of the slab
  std::vector<Arrival> arrived_;
  std::vector<VecD> x_, u_, carried_, impulse_, change_, row_sum_;
  std::vector<double> kappa_;
  std::vector<Answer> answers_;
  // Balance of this rank's last step: given to the fluid, received by points, sum of |J|
  VecD given_{}, received_{};
  double exchanged_ = 0.0, marker_gap_ = 0.0;
  double seconds_in_fluid_ = 0.0, seconds_in_coupling_ = 0.0;
};

/// The factory that the program hands to fix fluid/ib. Throws std::invalid_argument when the cells do not fit the box. Collective.
std::unique_ptr<FluidPartner> make_coupled_fluid(void *lammps, const FluidOptions &options);

}  // namespace swellflow
