// A fluid that solves nothing, in a scene of LIGGGHTS: it remembers what it was told and gives every point the same law.
#pragma once

#include <algorithm>
#include <memory>

#include "dry_scene.h"
#include "fix_property_atom.h"
#include "liggghts_plugins/fluid_columns.h"

namespace swellflow_test {

/// What passed between the fix and its fluid; outlives both.
struct FluidTalk {
  double kappa = 0.0, ax = 0.0, ay = 0.0;  ///< the law: force = a - kappa v
  std::vector<int> dem_steps = {1};        ///< of the coming fluid steps, over and over
  swellflow::FluidOptions options;
  std::vector<swellflow::FluidDrive> drives;
  std::vector<int> begun;                  ///< DEM steps of each step as begin_step heard it
  std::vector<double> received;            ///< sum of the impulses in x of this rank's points, each step
};

class FakeFluid : public swellflow::FluidPartner {
public:
  FakeFluid(LAMMPS_NS::LAMMPS *lmp, FluidTalk &talk) : lmp_(lmp), talk_(talk) {}

  void complete_law(const std::vector<swellflow::ObjectPoints> &, const swellflow::FluidDrive &) override {}
  int choose_dem_steps(double, const swellflow::FluidDrive &) override { return talk_.dem_steps[talk_.begun.size() % talk_.dem_steps.size()]; }
  void begin_step(const std::vector<swellflow::ObjectPoints> &, const swellflow::FluidDrive &drive, int dem_steps) override
  {
    talk_.drives.push_back(drive);
    talk_.begun.push_back(dem_steps);
    for (int i = 0; i < lmp_->atom->nlocal; i++) {
      const double law[] = {talk_.kappa, talk_.ax, talk_.ay, 0.0};
      std::copy(law, law + 4, columns(swellflow::FluidLaw::NAME)[i]);
      std::fill_n(columns(swellflow::FluidImpulse::NAME)[i], 3, 0.0);
    }
  }
  void finish_step(const std::vector<swellflow::ObjectPoints> &) override
  {
    double sum = 0.0;
    for (int i = 0; i < lmp_->atom->nlocal; i++) sum += columns(swellflow::FluidImpulse::NAME)[i][0];
    talk_.received.push_back(sum);
  }
  swellflow::FluidReport report() override
  {
    swellflow::FluidReport report;
    report.step = 7.0;
    report.mean_velocity = {8.0, 9.0, 0.0};
    report.driving_force = {10.0, 11.0, 0.0};
    report.force_of_sides = {12.0, 13.0, 0.0};
    report.momentum = {14.0, 15.0, 0.0};
    report.outflow = 16.0;
    report.force_of_growth = {17.0, 18.0, 0.0};
    return report;
  }
  double largest_speed() override { return 0.0; }
  void save(const std::string &) override {}
  void load(const std::string &, long, long) override {}
  bool add_scalar(const swellflow::ScalarOptions &) override { return false; }
  void remove_scalar(const std::string &) override {}
  swellflow::ScalarPartner *scalar(const std::string &) override { return nullptr; }
  swellflow::FieldBlock field_block() const override { return {}; }
  std::vector<swellflow::FieldInfo> fields() const override { return {}; }
  void copy_field(const std::string &, std::vector<double> &) const override {}
  std::vector<swellflow::PhaseTime> phase_times() const override { return {{"prediction", 3.0 * talk_.begun.size()}, {"projection", 1.0 * talk_.begun.size()}}; }
  double seconds_in_fluid() const override { return 0.0; }
  double seconds_in_coupling() const override { return 0.0; }

private:
  double **columns(const char *name) const
  {
    return static_cast<LAMMPS_NS::FixPropertyAtom *>(lmp_->modify->fix[lmp_->modify->find_fix(name)])->array_atom;
  }

  LAMMPS_NS::LAMMPS *lmp_;
  FluidTalk &talk_;
};

class FakeFluidScene : public DryScene {
public:
  FakeFluidScene()
  {
    swellflow::register_styles(lmp(), {[this](void *, const swellflow::FluidOptions &options) {
      talk.options = options;
      return std::make_unique<FakeFluid>(lmp(), talk);
    }, {}});
  }
  /// f_ID[n]; collective.
  double value(const std::string &id, int n) const { return fix(id)->compute_vector(n - 1); }

  FluidTalk talk;
};

}  // namespace swellflow_test
