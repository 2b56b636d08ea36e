// What a line `fix ID group fluid/scalar …` says.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "fluid_partner.h"
#include "script_value.h"

namespace swellflow {

/// Two dimensions: sides xlo, xhi, ylo, yhi.
class ScalarScript {
public:
  static constexpr int N_SIDES = 4;

  /// Reads the whole line. Throws OptionError.
  explicit ScalarScript(Arguments &line);

  double diffusivity() const { return diffusivity_; }
  double uptake() const { return uptake_; }
  const std::array<ScalarSideKind, 6> &sides() const { return sides_; }
  /// Throws OptionError when a side of the fluid does not allow what is said of it, or a region or a variable is not there.
  void require(LAMMPS_NS::LAMMPS *lmp, const std::array<SideKind, N_SIDES> &fluid_sides) const;
  /// Where the regions are now. The box and its regions must outlive the function's use.
  std::function<double(const Triple &)> initial(LAMMPS_NS::LAMMPS *lmp) const;
  bool varies() const;
  /// As the variables are now. Collective.
  std::array<double, 6> side_values(LAMMPS_NS::LAMMPS *lmp) const;

private:
  struct Part {
    std::string region;
    double value;
  };
  void read_side(Arguments &line, const std::string &keyword, ScalarSideKind kind);
  std::string what_is_wrong_with(int side, SideKind fluid_side) const;

  std::string place_;
  double diffusivity_ = 0.0, initial_ = 0.0, uptake_ = 1.0;
  std::vector<Part> parts_;
  std::array<ScalarSideKind, 6> sides_{};
  std::array<ScriptValue, N_SIDES> side_value_;
};

}  // namespace swellflow
