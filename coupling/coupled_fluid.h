// The coupled step: the fluid and LIGGGHTS' points, once a fluid step each way.
#pragma once

#include "coupling/coupled_scalar.h"
#include "coupling/courier.h"
#include "coupling/growth_sources.h"
#include "coupling/marker_ring.h"
#include "coupling/inner_fluid.h"
#include "coupling/inner_pressure.h"
#include "fluid/flow_rate.h"
#include "fluid/flow_solver.h"
#include "fluid/marker_solver.h"

namespace swellflow {

/// Direct-forcing immersed boundary (Uhlmann 2005; Guinea, Toriu & Ushijima 2022) in the form of docs/theory.md. A fluid step is
///
///   arrive      the markers of each ring point go to the slabs that hold them
///   predict     u~ with the force F_c that each marker gave in the step before, spread at its new place; with two projections div u~ = 0
///   ask         u~ at the markers
///   hand out    the force on a point, sum over its markers of kappa (u~ - c - v) less its shares of F_c, while LIGGGHTS takes its N steps
///   collect     the impulse I that each point truly received: with it the velocity V that the point had in the mean
///   spread      dJ = kappa dt (V + c - u~) for each marker; F_c of the point is then that of before plus the sum of dJ / dt
///   tighten     (forcing schemes other than direct) more impulse, so that u~ is V + c at the markers; the points receive it with the next step's law
///   project     div u = 0
///
/// with kappa = rho_f ds h / (beta dt), ds the spacing of the markers, beta the larger of the kernel's scale and the row sum (what comes back at a marker when
/// all are asked to change by 1: more than the scale only where markers crowd); c the marker's velocity less its point's when the step begins, less q (x - x_c)
/// if the object absorbs, q = (dA/dt) / (2A) of the outline's actual motion, bounded by absorption_rate. What points receive and what the fluid gives is equal to
/// round-off. The inertia and the weight of the fluid inside an object are returned (InnerFluid); in one that is light it has markers too, which carry no force.
template <int Dim> class CoupledFluid : public FluidPartner {
public:
  CoupledFluid(void *lammps, const FluidOptions &options, const Grid<Dim> &grid, const Boundaries<Dim> &boundaries);

  int choose_dem_steps(double dem_dt, const FluidDrive &drive) override;
  void begin_step(const std::vector<ObjectPoints> &objects, const FluidDrive &drive, int dem_steps) override;
  void complete_law(const std::vector<ObjectPoints> &objects, const FluidDrive &drive) override;
  void press_again(const std::vector<ObjectPoints> &objects, int dem_step) override;
  void finish_step(const std::vector<ObjectPoints> &objects) override;

  FluidReport report() override;
  double mean_slip() const override { return mean_slip_; }
  double largest_speed() override { return flow_.max_speed_sum(); }
  FieldBlock field_block() const override;
  std::vector<FieldInfo> fields() const override;
  void copy_field(const std::string &name, std::vector<double> &values) const override;
  std::vector<PhaseTime> phase_times() const override;
  double seconds_in_fluid() const override { return seconds_in_fluid_ + seconds_in_scalars(); }
  double seconds_in_coupling() const override { return seconds_in_coupling_; }

  bool add_scalar(const ScalarOptions &options) override;
  void remove_scalar(const std::string &name) override;
  ScalarPartner *scalar(const std::string &name) override;

  void save(const std::string &file) override;
  void load(const std::string &file, long begin, long end) override;

  // For its scalars, after a step
  const FlowSolver<Dim> &flow() const { return flow_; }
  double last_step() const { return last_dt_; }
  Markers<Dim> &markers() { return *markers_; }
  /// Of the markers on this rank's slab, when the step began.
  std::span<const Vec<Dim>> marker_places() const { return x_; }
  std::span<const double> marker_spacings() const { return spacing_; }
  /// From own points to their markers on outlines, in the order of the places. Collective.
  void tell_markers(const std::vector<double> &by_point, std::vector<double> &by_marker);
  /// And back: by own point. Collective.
  void hear_markers(const std::vector<double> &by_marker, std::vector<ScalarMet> &by_point);

private:
  using VecD = Vec<Dim>;
  /// What comes back from the slab.
  struct Answer {
    VecD u;
    double kappa;
  };
  /// What a point reports when the step ends, to the rank on which it was when the step began.
  struct Report {
    int slot;
    VecD impulse;
  };
  /// The account of an own ring point, or of a hub that bears markers: its markers are those at first … first + count - 1, of which the first n_carrying carry force.
  struct Account {
    int point, first, count, n_carrying;
    VecD carried, felt;  ///< force F_c of all its markers; its share of all F_c and of what is owed
  };
  struct Described {
    ObjectMotion motion;
    bool filled;
  };
  /// Markers that set out for their slabs, each property in a row of its own; what is sent is not changed before the next step.
  struct Leaving {
    std::vector<VecD> x, carried;  ///< places; the impulses that the markers carry
    std::vector<VecD> offset;      ///< c: by how much the velocity differs from the point's
    std::vector<double> spacing;
    std::vector<int> to;
    std::size_t size() const { return x.size(); }
    void resize(std::size_t n)
    {
      for (auto *rows : {&x, &carried, &offset}) rows->resize(n);
      spacing.resize(n);
      to.resize(n);
    }
  };

  void keep(Checkpoint &file);
  void require_same_box(Checkpoint &file);
  double seconds_in_scalars() const;
  void drive(const FluidDrive &drive);
  bool some_markers() const;
  void describe_markers(const std::vector<ObjectPoints> &objects, const Triple &gravity);
  void describe_object(const ObjectPoints &object, const Triple &gravity);
  int markers_of(const ObjectPoints &object, int k) const;
  void open_accounts(const ObjectPoints &object, double inward_rate);
  void open_account(const ObjectPoints &object, int k, int own, int first, double inward_rate);
  template <class Marker> void send_marker(int m, const Marker &marker, double spacing, const VecD &carried_impulse, const double *v_point, double inward_rate);
  void share_carried_force(const ObjectPoints &object);
  void share_owed_impulse(const ObjectPoints &object);
  void agree_on_slip();
  void require_finite_flow(double not_finite) const;
  double uniform_pressure(const ObjectPoints &object) const;
  double natural_rate(const ObjectPoints &object) const;
  double absorption_rate(const ObjectPoints &object) const;
  double chord_rate(double spin) const;
  int markers_per_point(const ObjectPoints &object) const;
  int slab_of(const VecD &x) const;
  void arrive();
  void spread_carried();
  void ask_fluid();
  void hand_out();
  void collect(const std::vector<ObjectPoints> &objects);
  VecD settle(const Report &report);
  void spread(std::span<const VecD> impulses);
  void force(std::span<const VecD> impulses);
  void tighten();
  void find_remaining_slip();
  void owe(const std::vector<VecD> &extra);
  VecD given_to_fluid() const;
  void note_inflating(const std::vector<ObjectPoints> &objects);
  void grow_inside(const std::vector<ObjectPoints> &objects);
  double excess_growth(const ObjectPoints &object) const;
  void note_sides();
  void measure_slip();
  int any_own(const ObjectPoints &object) const;

  FlowSolver<Dim> flow_;
  FaceForcing<Dim> row_sums_;
  std::unique_ptr<Markers<Dim>> markers_;
  std::unique_ptr<MarkerSolver<Dim>> marker_solver_;  // of implicit forcing
  FlowRate<Dim> flow_rate_;
  DemEngine points_;
  MarkerRing ring_;
  InnerFluid inner_fluid_;
  InnerPressure inner_pressure_;
  Courier to_slabs_, to_homes_, to_sources_;
  FluidOptions options_;
  std::vector<std::unique_ptr<CoupledScalar<Dim>>> scalars_;
  std::unique_ptr<CheckpointReader> loaded_;  // until the first step, for scalars that join
  double dt_ = 0.0, dt_before_ = 0.0;
  int dem_steps_ = 1;

  // On the rank that has the point when the step begins
  std::vector<Described> described_;
  std::vector<Account> accounts_;
  Leaving leaving_;
  std::vector<VecD> leaving_change_, felt_;
  Arrivals<Answer> answers_here_;
  double uniform_pressure_ = 0.0;  // of the object that is being described
  // On the rank that has it when the step ends, and what comes to the former
  std::vector<Report> reports_;
  Arrivals<Report> arrived_reports_;
  std::vector<int> reporting_, to_;
  std::vector<VecD> new_force_, owed_;
  Arrivals<VecD> new_force_here_, owed_here_, extra_back_;
  // On the rank of the slab
  Arrivals<VecD> x_, carried_, change_;
  Arrivals<double> spacing_;
  std::vector<Answer> answers_;
  std::vector<VecD> u_, u_after_, row_sum_, wanted_, slip_, extra_, all_extra_;
  // Sources inside objects that inflate, on the rank of the hub and on those of the slabs
  std::vector<SourcePoint> leaving_sources_;
  Arrivals<SourcePoint> arrived_sources_;
  bool some_inflate_ = false;  ///< or once did
  // This rank's part of the last whole step: given to the fluid, received by points, owed to them before less after, the sum of these, sum of |J|; slip;
  // largest divergence
  VecD given_{}, received_{}, given_late_{}, owed_balance_{}, balance_{}, last_body_force_{}, given_by_sides_{}, given_by_growth_{};
  double last_dt_ = 0.0, exchanged_ = 0.0, outflow_ = 0.0, marker_gap_ = 0.0, last_marker_gap_ = 0.0, slip_sum_ = 0.0, slip_count_ = 0.0, slip_max_ = 0.0, mean_slip_ = 0.0, max_divergence_ = 0.0;
  double seconds_in_fluid_ = 0.0, seconds_in_coupling_ = 0.0;
};

/// The factory that the program hands to fix fluid/ib. Throws std::invalid_argument when the cells do not fit the box. Collective.
std::unique_ptr<FluidPartner> make_coupled_fluid(void *lammps, const FluidOptions &options);

}  // namespace swellflow
