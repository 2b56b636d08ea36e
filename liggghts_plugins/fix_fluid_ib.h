// The fluid around the objects, as a script names it. The fix parses, keeps what must migrate with the points, and says when; the FluidPartner computes.
#pragma once

#include <memory>
#include <vector>

#include "fix.h"
#include "fluid_accuracy.h"
#include "fluid_partner.h"
#include "fluid_script.h"
#include "limits.h"
#include "phase_line.h"
#include "slip_look.h"
#include "stop_request.h"

namespace LAMMPS_NS {

class FixPropertyAtom;

class FixFluidIb : public Fix, public swellflow::KnowsFigures {
 public:
  FixFluidIb(class LAMMPS *, int narg, char **arg, const swellflow::FluidPartnerFactory &make_partner, const swellflow::AccuracyPreset &accuracy);

  int setmask() override;
  void post_create() override;
  void pre_delete(bool unfixflag) override;
  void init() override;
  void setup(int) override;
  void pre_initial_integrate() override;
  void end_of_step() override;
  void post_run() override;
  double compute_scalar() override;
  double compute_vector(int n) override;
  void add_limits(std::vector<swellflow::Figure> &figures) override;
  void add_accuracy(std::vector<swellflow::Figure> &figures) override;

  /// Null before the first run.
  const swellflow::FluidPartner *partner() const { return partner_.get(); }
  swellflow::FluidPartner *partner() { return partner_.get(); }
  double density() const { return script_->options().density; }
  double cell() const;  ///< its width
  double kinematic_viscosity() const { return script_->options().kinematic_viscosity; }
  /// Between begin and end of a DEM step: whether it is the first, or the last, of its fluid step.
  bool first_dem_step() const { return dem_step_ == 0; }
  bool last_dem_step() const { return dem_step_ + 1 == dem_steps_; }
  int dem_step() const { return dem_step_; }  ///< between two: how many of the fluid step under way have been made; 0: none is under way
  int dem_steps_per_step() const { return script_->options().cfl > 0.0 ? dem_steps_ : script_->options().dem_steps_per_fluid_step; }
  bool chooses_steps() const { return script_->options().cfl > 0.0; }
  bigint whole_steps() const { return whole_steps_; }
  /// In LIGGGHTS' order: xlo, xhi, ylo, yhi.
  swellflow::SideKind side(int k) const { return script_->options().sides[k]; }

 private:
  void parse(int narg, char **arg, const swellflow::AccuracyPreset &accuracy);
  double smallest_object() const;
  void require_settings();
  void require_sides();
  void require_integrators();
  void require_same_step();
  void require_way_out();
  const class FixSwell *inflating_swell() const;
  void warn_without_resistance();
  void add_cfl_limit(std::vector<swellflow::Figure> &figures);
  swellflow::Figure cfl_figure(double value, const std::string &where) const;
  void add_limits_of_objects(std::vector<swellflow::Figure> &figures);
  bool moves_objects() const;
  bool moves_only_rigid_objects() const;
  swellflow::Figure viscous_figure(int dem_steps) const;
  double largest_marker_gap(const swellflow::ObjectPoints &object) const;
  double largest_speed_of_points() const;
  void note_accuracy();
  void judge_slip(long least);
  void make_partner();
  void continue_from_file();
  int up_to_next_stop(int dem_steps) const;
  void begin_step();
  void note_outer_forces();
  const std::vector<swellflow::ObjectPoints> &objects();
  void note_springs();
  swellflow::FluidDrive drive();
  const swellflow::FluidReport &report();

  std::unique_ptr<swellflow::FluidScript> script_;
  double box_low_[2], box_high_[2];  // when the line was read
  swellflow::FluidPartnerFactory make_partner_;
  std::unique_ptr<swellflow::FluidPartner> partner_;
  FixPropertyAtom *law_ = nullptr, *ahead_ = nullptr, *carried_ = nullptr;
  std::vector<swellflow::ObjectPoints> objects_;
  PhaseLine phases_;
  StopRequest stop_;
  double dt_ = 0.0;     // DEM step of the fluid step under way
  int dem_steps_ = 1;   // in the fluid step under way
  int dem_step_ = 0;    // within the fluid step; 0: none is under way
  bigint whole_steps_ = 0, steps_before_run_ = 0;
  bool warned_ = false;
  bool has_free_objects_ = false, has_only_rigid_objects_ = false;
  bool has_heavy_objects_ = false;  // in the fluid step under way, on any rank
  swellflow::FluidReport report_;
  bigint reported_step_ = -1;
  swellflow::FluidAccuracy worst_;  // of the run
  swellflow::SlipLook slip_;        // the same
  bigint run_end_ = -1;  // of the last run that was set up
};

/// The fluid of a scene, or null.
FixFluidIb *find_fluid(class LAMMPS *);

}  // namespace LAMMPS_NS
