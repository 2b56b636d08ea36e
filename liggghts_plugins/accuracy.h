// The command `accuracy`: one word for what trades speed for accuracy, and what it sets.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace LAMMPS_NS {
class LAMMPS;
}

namespace swellflow {

struct FluidOptions;

/// Defaults of what later lines leave out; what is not set here keeps its own.
struct AccuracyPreset {
  std::string name;                   ///< empty: the command was not given
  std::optional<int> points = {};     ///< `points` of create_objects
  std::optional<int> across = {};     ///< fluid cells across the smallest object, for `cells auto` of fix fluid/ib
  std::optional<double> cfl = {};     ///< `cfl` of fix fluid/ib, where `every` is given
  bool has_box = false;               ///< whether the box is there that it holds for: another one, after `clear`, has none

  std::string words() const;          ///< as the user is told
};

/// By name.
const std::vector<AccuracyPreset> &accuracy_presets();

/// The command: `accuracy fast | balanced | accurate` changes `preset`, `accuracy report` prints the budget.
void accuracy_command(LAMMPS_NS::LAMMPS *lmp, int narg, char **arg, AccuracyPreset &preset);

}  // namespace swellflow
