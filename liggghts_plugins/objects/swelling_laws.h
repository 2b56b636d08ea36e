// Natural diameter as a function of time; free of LIGGGHTS.
#pragma once

#include <algorithm>

namespace swellflow {

/// D = min(D_start + rate t, D_max): eqs. (7) and (8) of Guinea, Toriu and Ushijima (2022).
struct LinearSwelling {
  double rate = 0.0;              ///< diameter per time
  double largest_diameter = 0.0;

  double diameter(double start_diameter, double elapsed) const
  {
    return std::min(start_diameter + rate * elapsed, largest_diameter);
  }
};

/// Elapsed time in steps of a length that may change between runs. Counting steps, not adding them up, makes a run in two
/// parts equal to one run.
struct SwellingClock {
  double base_time = 0.0;
  long base_step = 0;
  double step_length = 0.0;

  double time(long step) const { return base_time + static_cast<double>(step - base_step) * step_length; }
  /// From `step` on a step is `new_length` long.
  void change_step_length(long step, double new_length)
  {
    if (new_length == step_length) return;
    base_time = time(step);
    base_step = step;
    step_length = new_length;
  }
  /// The steps are counted anew, from `new_step` instead of `old_step`.
  void renumber(long new_step, long old_step) { base_step += new_step - old_step; }
};

}  // namespace swellflow
