// What a line of fix fluid/ib says: what stays goes into FluidOptions, what a variable may change into FluidDrive.
#pragma once

#include <array>
#include <functional>
#include <string>

#include "accuracy.h"
#include "fluid_partner.h"
#include "script_value.h"

namespace swellflow {

class Options;

/// Two dimensions: directions x and y, sides xlo, xhi, ylo, yhi.
class FluidScript {
public:
  /// The box as the script's `boundary` and `create_box` made it.
  struct Box {
    std::array<bool, 2> periodic;
    std::array<double, 2> length;
    std::function<double()> smallest_object;  ///< diameter as it was made; 0: there are no objects. Collective
  };

  /// Reads the whole line; what it leaves out is as `accuracy` has it. Throws OptionError. Collective.
  FluidScript(Arguments &line, const Box &box, const AccuracyPreset &accuracy);

  /// All but the initial velocities of the fluid and its sides.
  const FluidOptions &options() const { return options_; }
  /// What the user is told of the line, or nothing.
  const std::string &remark() const { return remark_; }
  /// Throws OptionError when a variable is not there.
  void require_variables(LAMMPS_NS::LAMMPS *lmp) const;
  bool varies() const;
  /// As the variables are now. Throws OptionError when they break a rule. Collective, without gravity, which is not the fluid's.
  FluidDrive drive(LAMMPS_NS::LAMMPS *lmp) const;
  Triple initial_velocity(LAMMPS_NS::LAMMPS *lmp) const;
  /// Whether a force acts along a periodic direction and no side resists.
  bool is_driven_without_resistance() const;
  bool has_inflow() const { return has(SideKind::inflow) || has(SideKind::parabolic_inflow); }
  bool has_outflow() const { return has(SideKind::outflow); }

private:
  static constexpr int DIM = 2, N_SIDES = 2 * DIM;
  using Pair = std::array<ScriptValue, DIM>;

  void read_cells(Arguments &line, const AccuracyPreset &accuracy);
  void declare_sides(Options &options);
  void declare_driving(Options &options);
  void declare_method(Options &options);
  int read_side(Arguments &line, const std::string &keyword);
  void read_mean_velocity(Arguments &line);
  void read_initial_velocity(Arguments &line);
  void check(const Arguments &line, const Options &options) const;
  void check_flow_through(const Arguments &line) const;
  void check_driving(const Arguments &line) const;
  int direction_between_walls(const Arguments &line) const;
  std::string what_is_wrong_with(int side, double normal_velocity) const;
  bool has(SideKind kind) const;
  bool moves(int side) const;
  bool is_driven(int d) const { return !body_force_[d].is_zero() || !pressure_drop_[d].is_zero(); }
  template <class Visit> void for_each_value(const Visit &visit) const;

  std::string place_, remark_;
  Box box_;
  FluidOptions options_;
  std::array<bool, N_SIDES> named_{};
  bool starts_linear_ = false;
  std::array<Pair, N_SIDES> side_velocity_;
  Pair body_force_, pressure_drop_, mean_velocity_, initial_velocity_;
};

}  // namespace swellflow
