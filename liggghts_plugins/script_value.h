// A value that a script gives as a number, or as v_NAME of an equal-style variable that is evaluated anew each time.
#pragma once

#include <functional>
#include <string>

#include "lmptype.h"

namespace LAMMPS_NS {
class LAMMPS;
}

namespace swellflow {

class Arguments;

class ScriptValue {
public:
  ScriptValue(double number = 0.0) : number_(number) {}
  /// The next word of the line; `what` and `unit` are for messages. Throws OptionError.
  static ScriptValue read(Arguments &line, const std::string &what, const std::string &unit);

  bool is_variable() const { return !variable_.empty(); }
  bool is_zero() const { return !is_variable() && number_ == 0.0; }
  double number() const { return number_; }  ///< of a value that is no variable
  const std::string &variable() const { return variable_; }

  /// Throws OptionError, on every rank alike, when the variable is not there or of another style.
  void require(LAMMPS_NS::LAMMPS *lmp) const;
  /// Throws OptionError when the variable's value is not a finite number. Collective.
  double evaluate(LAMMPS_NS::LAMMPS *lmp) const;

private:
  double number_ = 0.0;
  std::string variable_, what_;  ///< what_: place and name, for messages
};

/// Runs `work`, which evaluates variables within a step: computes that these need are told that `next_step` is when they are asked again.
/// An OptionError ends the run. Collective.
void with_variables(LAMMPS_NS::LAMMPS *lmp, LAMMPS_NS::bigint next_step, const std::function<void()> &work);

/// The same at a step that is still to come: `step`, `time` and their like in formulas are those of `step`, all else is as it is now.
void with_variables_at(LAMMPS_NS::LAMMPS *lmp, LAMMPS_NS::bigint step, LAMMPS_NS::bigint next_step, const std::function<void()> &work);

}  // namespace swellflow
