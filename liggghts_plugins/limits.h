// Figures of a scene or a run, each beside its bounds, and how those who know some tell them. The guard and the accuracy budget only ask.
#pragma once

#include <limits>
#include <string>
#include <vector>

namespace LAMMPS_NS {
class LAMMPS;
}

namespace swellflow {

/// Larger is worse. Of a limit (KnowsFigures::add_limits), `poor` is where a run must fail: beyond it is refused, between the two is a warning.
struct Figure {
  static constexpr double never = std::numeric_limits<double>::infinity();

  std::string name;     ///< what is compared with what, in a few words: "time step / limit of the springs"
  double value = 0.0;
  double watch = 0.0;   ///< up to here it is fine
  double poor = never;  ///< above this it is poor; `never`: no such bound is known
  std::string place;    ///< where it is worst: "object (molecule) 7, fix springs"
  std::string remedy;   ///< what would better it most, as an order: "shorten 'timestep'"

  /// A value that is not a number is poor.
  bool is_fine() const { return value <= watch; }
  bool is_poor() const { return !(value <= poor); }
  const char *word() const { return is_poor() ? "poor" : is_fine() ? "fine" : "watch"; }
};

/// What a fix that knows figures implements besides Fix. Both calls are collective, and all ranks append the same figures in the same order; a fix appends nothing for parts that the scene
/// has not.
class KnowsFigures {
public:
  virtual ~KnowsFigures() = default;
  /// Before the first step of a run, in setup: objects are listed, ghosts are there, the fluid is made. From the objects as they are.
  virtual void add_limits(std::vector<Figure> &) {}
  /// Of the run up to now: the worst since it began where that costs next to nothing, else the last.
  virtual void add_accuracy(std::vector<Figure> &) {}
};

/// Those of all fixes and of contacts, in the order of the script. Collective.
std::vector<Figure> limits_of(LAMMPS_NS::LAMMPS *lmp);
std::vector<Figure> accuracy_of(LAMMPS_NS::LAMMPS *lmp);

}  // namespace swellflow
