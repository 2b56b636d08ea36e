#include "script_value.h"

#include <cmath>

#include "compute.h"
#include "input.h"
#include "lammps.h"
#include "modify.h"
#include "options.h"
#include "update.h"
#include "variable.h"

using namespace LAMMPS_NS;

namespace swellflow {

namespace {

int place_of(LAMMPS *lmp, const std::string &variable) { return lmp->input->variable->find(const_cast<char *>(variable.c_str())); }

/// LIGGGHTS reckons `time` from the number of the step and the time at which the run began, so that the number is all that has to change.
class StepToCome {
public:
  StepToCome(LAMMPS *lmp, bigint step) : lmp_(lmp), present_(lmp->update->ntimestep), step_(step) { lmp_->update->ntimestep = step_; }
  ~StepToCome()
  {
    lmp_->update->ntimestep = present_;
    if (step_ == present_) return;
    // Computes note the step of their values: without this they would give today's again when that step has come.
    for (int i = 0; i < lmp_->modify->ncompute; i++) {
      Compute &compute = *lmp_->modify->compute[i];
      for (bigint *noted : {&compute.invoked_scalar, &compute.invoked_vector, &compute.invoked_array, &compute.invoked_peratom, &compute.invoked_local})
        if (*noted == step_) *noted = -1;
    }
  }
  StepToCome(const StepToCome &) = delete;
  StepToCome &operator=(const StepToCome &) = delete;

private:
  LAMMPS *lmp_;
  bigint present_, step_;
};

}  // namespace

ScriptValue ScriptValue::read(Arguments &line, const std::string &what, const std::string &unit)
{
  ScriptValue value;
  value.what_ = line.place() + ": '" + what + "'";
  if (line.empty()) line.fail("not enough arguments for '" + what + "': give a number (" + unit + ") or v_NAME of an equal-style variable");
  if (line.peek().rfind("v_", 0) != 0) {
    value.number_ = line.number(what, Range::any(), unit + ", or v_NAME of an equal-style variable");
    return value;
  }
  value.variable_ = line.word(what).substr(2);
  if (value.variable_.empty()) line.fail("'" + what + "' must name its variable behind v_, but is 'v_': change it");
  return value;
}

void ScriptValue::require(LAMMPS *lmp) const
{
  if (!is_variable()) return;
  const int place = place_of(lmp, variable_);
  if (place >= 0 && lmp->input->variable->equalstyle(place)) return;
  throw OptionError(what_ + " must come from an equal-style variable, but '" + variable_ + "' is " +
                    (place < 0 ? "not defined" : "of another style") + ": add 'variable " + variable_ + " equal ...'");
}

double ScriptValue::evaluate(LAMMPS *lmp) const
{
  if (!is_variable()) return number_;
  require(lmp);  // a script may delete it between runs
  const double value = lmp->input->variable->compute_equal(place_of(lmp, variable_));
  if (!(std::abs(value) <= largest_number))
    throw OptionError(what_ + " must be a finite number" + magnitude_words(value) + ", but variable '" + variable_ + "' gave " + shown(value) + " for step " +
                      std::to_string(lmp->update->ntimestep) + ": change its formula");
  return value;
}

void with_variables(LAMMPS *lmp, bigint next_step, const std::function<void()> &work)
{
  lmp->modify->clearstep_compute();
  or_stop(lmp, work);
  lmp->modify->addstep_compute(next_step);
}

void with_variables_at(LAMMPS *lmp, bigint step, bigint next_step, const std::function<void()> &work)
{
  with_variables(lmp, next_step, [&] {
    const StepToCome there(lmp, step);
    work();
  });
}

}  // namespace swellflow
