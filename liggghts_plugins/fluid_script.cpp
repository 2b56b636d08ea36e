#include "fluid_script.h"

#include <algorithm>

#include "lammps.h"
#include "options.h"
#include "square_cells.h"
#include "update.h"

namespace swellflow {

namespace {

const std::vector<std::string> side_names = {"xlo", "xhi", "ylo", "yhi"};
const std::vector<std::string> directions = {"x", "y"};

std::array<ScriptValue, 2> read_pair(Arguments &line, const std::string &what, const std::string &unit)
{
  ScriptValue x = ScriptValue::read(line, what + ", x", unit);
  return {x, ScriptValue::read(line, what + ", y", unit)};
}

}  // namespace

FluidScript::FluidScript(Arguments &line, const Box &box, const AccuracyPreset &accuracy) : place_(line.place()), box_(box)
{
  for (int side = 0; side < N_SIDES; side++)
    if (box_.periodic[side / 2]) options_.sides[side] = SideKind::periodic;
  Options options(place_);
  options.custom("cells", [&](Arguments &words) { read_cells(words, accuracy); }, "NX NY: cells across the box; or auto").required();
  options.number("density", options_.density, Range::positive(), "mass/length^3", "density of the fluid").required();
  options.number("viscosity", options_.kinematic_viscosity, Range::positive(), "length^2/time", "kinematic viscosity").required();
  options.integer("every", options_.dem_steps_per_fluid_step, Range::at_least(1), "DEM steps in a fluid step");
  options.number("cfl", options_.cfl, Range::positive(), "", "as many DEM steps, at most 'every', as keep the CFL number below this");
  declare_sides(options);
  declare_driving(options);
  declare_method(options);
  options.parse(line);
  if (options.given("every") && !options.given("cfl")) options_.cfl = accuracy.cfl.value_or(0.0);
  check(line, options);
  if (starts_linear_) options_.linear_start = direction_between_walls(line);
}

// ---- keywords --------------------------------------------------------------------------------------------------------------------------------

void FluidScript::read_cells(Arguments &line, const AccuracyPreset &accuracy)
{
  if (line.empty() || line.peek() != "auto") {
    for (int d = 0; d < DIM; d++) options_.cells[d] = line.integer("cells", Range::at_least(4));
    return;
  }
  line.expect("auto");
  if (!accuracy.across)
    line.fail("'cells auto' takes the number of cells across the smallest object from the command 'accuracy', which was not given: add 'accuracy balanced' above 'create_objects', or give 'cells NX NY'");
  const double diameter = box_.smallest_object();
  if (diameter == 0.0) line.fail("'cells auto' goes by the smallest object, but there is none: put this line below 'create_objects', or give 'cells NX NY'");
  try {
    const std::array<int, DIM> cells = square_cells(box_.length, diameter / *accuracy.across);
    std::copy(cells.begin(), cells.end(), options_.cells.begin());
  } catch (const std::invalid_argument &problem) {
    line.fail(problem.what());
  }
  remark_ = place_ + ": cells " + std::to_string(options_.cells[0]) + " " + std::to_string(options_.cells[1]) + ", " + rounded(diameter * options_.cells[0] / box_.length[0]) +
            " across the smallest object (accuracy " + accuracy.name + ")";
}

void FluidScript::declare_sides(Options &options)
{
  options.custom("wall", [&](Arguments &words) {
    const int side = read_side(words, "wall");
    words.choice("wall", {"velocity"});
    side_velocity_[side] = read_pair(words, "wall " + side_names[side] + " velocity", "length/time");
  }, "SIDE velocity VX VY: a no-slip side that moves within its plane").repeatable();
  options.custom("slip", [&](Arguments &words) { options_.sides[read_side(words, "slip")] = SideKind::slip; },
                 "SIDE: a free-slip side").repeatable();
  options.custom("inflow", [&](Arguments &words) {
    const int side = read_side(words, "inflow");
    const bool parabolic = words.choice("inflow", {"uniform", "parabolic"}) == 1;
    options_.sides[side] = parabolic ? SideKind::parabolic_inflow : SideKind::inflow;
    side_velocity_[side] = read_pair(words, "inflow " + side_names[side], "length/time");
  }, "SIDE uniform|parabolic VX VY: a side with given velocity").repeatable();
  options.custom("outflow", [&](Arguments &words) { options_.sides[read_side(words, "outflow")] = SideKind::outflow; },
                 "SIDE: a side through which the fluid leaves").repeatable();
}

void FluidScript::declare_driving(Options &options)
{
  options.custom("body_force", [&](Arguments &words) { body_force_ = read_pair(words, "body_force", "length/time^2"); },
                 "GX GY: force per mass of fluid");
  options.custom("pressure_drop", [&](Arguments &words) { pressure_drop_ = read_pair(words, "pressure_drop", "pressure"); },
                 "DPX DPY: fall of pressure across the periodic box");
  options.custom("mean_velocity", [&](Arguments &words) { read_mean_velocity(words); }, "DIR U: mean velocity of the box that is held").repeatable();
  options.custom("initial_velocity", [&](Arguments &words) { read_initial_velocity(words); },
                 "VX VY or linear: of all fluid at the start, or between that of two walls");
}

void FluidScript::declare_method(Options &options)
{
  options.custom("advection", [&](Arguments &words) {
    options_.advection = static_cast<AdvectionScheme>(words.choice("advection", {"central", "bounded", "none"}));
  }, "central, bounded or none");
  options.custom("forcing", [&](Arguments &words) {
    options_.forcing = static_cast<ForcingScheme>(words.choice("forcing", {"direct", "multi", "implicit"}));
    if (options_.forcing == ForcingScheme::multi) options_.forcing_loops = words.integer("forcing multi", {.low = 1.0, .high = 1000.0});
  }, "direct, multi N or implicit");
  options.custom("kernel", [&](Arguments &words) {
    const std::vector<std::string> kernels = {"roma_1999", "peskin_2002", "yang_2009", "gruninger_2025"};
    options_.kernel = kernels[words.choice("kernel", kernels)];
  }, "delta kernel between markers and cells");
  options.custom("retraction", [&](Arguments &words) {
    if (words.next_is_number()) options_.retraction = words.number("retraction", Range::not_negative(), "cells");
    else words.choice("retraction", {"kernel"});
  }, "R cells, or 'kernel': of the markers, from the ring point towards the hub");
  options.custom("projections", [&](Arguments &words) { options_.projections = 1 + words.choice("projections", {"1", "2"}); }, "1 or 2: whether markers meet a fluid that is divergence-free");
  options.number("marker_gap", options_.marker_gap, Range::at_least(0.01), "cells", "largest natural distance of markers along a ring");
}

int FluidScript::read_side(Arguments &line, const std::string &keyword)
{
  const int side = line.choice(keyword, side_names);
  if (named_[side]) line.fail("each side is described once, but " + side_names[side] + " is here twice: take one of them out");
  named_[side] = true;
  if (box_.periodic[side / 2])
    line.fail("a periodic direction has no sides, but '" + keyword + " " + side_names[side] + "' describes one and boundary " +
              directions[side / 2] + " is 'p': leave '" + keyword + "' out, or put f there in 'boundary'");
  return side;
}

void FluidScript::read_mean_velocity(Arguments &line)
{
  const int d = line.choice("mean_velocity", directions);
  if (options_.controlled[d])
    line.fail("the mean velocity is given once a direction, but 'mean_velocity " + directions[d] + "' is here twice: take one of them out");
  if (!box_.periodic[d])
    line.fail("a mean velocity can be held along a periodic direction, but boundary " + directions[d] + " is not 'p': put p there in 'boundary', or use 'inflow'");
  options_.controlled[d] = true;
  mean_velocity_[d] = ScriptValue::read(line, "mean_velocity " + directions[d], "length/time");
}

void FluidScript::read_initial_velocity(Arguments &line)
{
  if (line.empty() || line.next_is_number() || line.peek().starts_with("v_")) {
    initial_velocity_ = read_pair(line, "initial_velocity", "length/time");
    return;
  }
  const std::string word = line.word("initial_velocity");
  if (word != "linear")
    line.fail("'initial_velocity' must be 'linear', or two numbers (length/time) or v_NAME of equal-style variables, but it is '" + word + "': change it");
  starts_linear_ = true;
}

// ---- rules -----------------------------------------------------------------------------------------------------------------------------------

bool FluidScript::has(SideKind kind) const
{
  const auto end = options_.sides.begin() + N_SIDES;
  return std::find(options_.sides.begin(), end, kind) != end;
}

void FluidScript::check(const Arguments &line, const Options &options) const
{
  if (options.given("cfl") && !options.given("every"))
    line.fail("'cfl' chooses a number of DEM steps up to that of 'every', but 'every' is missing: add 'every N' with the most there may be");
  for (int side = 0; side < N_SIDES; side++) {
    const ScriptValue &normal = side_velocity_[side][side / 2];
    const std::string problem = normal.is_variable() ? "" : what_is_wrong_with(side, normal.number());
    if (!problem.empty()) line.fail(problem);
  }
  check_flow_through(line);
  check_driving(line);
}

bool FluidScript::moves(int side) const
{
  const Pair &velocity = side_velocity_[side];
  return options_.sides[side] == SideKind::wall && std::any_of(velocity.begin(), velocity.end(), [](const ScriptValue &v) { return !v.is_zero(); });
}

/// A flow can begin linear across a pair of walls when no other pair drags the fluid along. A wall whose velocity is a variable counts as one that moves.
int FluidScript::direction_between_walls(const Arguments &line) const
{
  const std::string rule = "'initial_velocity linear' lies between two walls that face each other, of which no others move, but ";
  const std::string remedy = ": change the sides, or give the initial velocity as VX VY";
  int between = -1, moving = -1;
  for (int d = 0; d < DIM; d++) {
    const int lower = 2 * d, upper = lower + 1;
    const bool move = moves(lower) || moves(upper), face = options_.sides[lower] == SideKind::wall && options_.sides[upper] == SideKind::wall;
    if (move && moving >= 0) line.fail(rule + "walls move in x and in y" + remedy);
    if (move && !face) line.fail(rule + side_names[moves(lower) ? lower : upper] + " moves and " + side_names[moves(lower) ? upper : lower] + " is no wall" + remedy);
    if (move) moving = d;
    if (move || (face && moving < 0)) between = d;
  }
  if (between < 0) line.fail(rule + "there are none" + remedy);
  return between;
}

/// The fluid is incompressible: what enters must leave. What an outflow is for the fix knows when all of the scene is there.
void FluidScript::check_flow_through(const Arguments &line) const
{
  if (has_inflow() && !has_outflow()) line.fail("what flows in must leave, but there is an 'inflow' and no side to leave through: add 'outflow SIDE'");
}

void FluidScript::check_driving(const Arguments &line) const
{
  for (int d = 0; d < DIM; d++) {
    if (!pressure_drop_[d].is_zero() && !box_.periodic[d])
      line.fail("a pressure drop acts along a periodic direction, but boundary " + directions[d] +
                " is not 'p': set it to 0 there, or put p there in 'boundary'");
    if (options_.controlled[d] && is_driven(d)) {
      const std::string other = body_force_[d].is_zero() ? "pressure_drop" : "body_force";
      line.fail("'mean_velocity " + directions[d] + "' chooses the force that drives the flow, but '" + other +
                "' gives one in the same direction: set it to 0 there, or leave 'mean_velocity' out");
    }
  }
}

/// Nothing, or rule, value and remedy.
std::string FluidScript::what_is_wrong_with(int side, double normal_velocity) const
{
  const bool lower = side % 2 == 0;
  switch (options_.sides[side]) {
    case SideKind::wall:
      if (normal_velocity == 0.0) return "";
      return "a wall moves within its plane, but the normal component of its velocity on " + side_names[side] + " is " + shown(normal_velocity) + ": set it to 0";
    case SideKind::inflow:
    case SideKind::parabolic_inflow:
      if (lower ? normal_velocity >= 0.0 : normal_velocity <= 0.0) return "";
      return "an inflow points into the box, but on " + side_names[side] + " its velocity in " + directions[side / 2] + " is " + shown(normal_velocity) +
             ": change its sign, or exchange 'inflow' and 'outflow'";
    default: return "";
  }
}

bool FluidScript::is_driven_without_resistance() const
{
  for (SideKind kind : {SideKind::wall, SideKind::inflow, SideKind::parabolic_inflow, SideKind::outflow})
    if (has(kind)) return false;
  for (int d = 0; d < DIM; d++)
    if (box_.periodic[d] && is_driven(d)) return true;
  return false;
}

// ---- values ----------------------------------------------------------------------------------------------------------------------------------

template <class Visit> void FluidScript::for_each_value(const Visit &visit) const
{
  for (const Pair &pair : side_velocity_) std::for_each(pair.begin(), pair.end(), visit);
  for (const Pair *pair : {&body_force_, &pressure_drop_, &mean_velocity_}) std::for_each(pair->begin(), pair->end(), visit);
}

void FluidScript::require_variables(LAMMPS_NS::LAMMPS *lmp) const
{
  for_each_value([lmp](const ScriptValue &value) { value.require(lmp); });
  for (const ScriptValue &value : initial_velocity_) value.require(lmp);
}

bool FluidScript::varies() const
{
  bool varies = false;
  for_each_value([&](const ScriptValue &value) { varies = varies || value.is_variable(); });
  return varies;
}

FluidDrive FluidScript::drive(LAMMPS_NS::LAMMPS *lmp) const
{
  FluidDrive drive;
  for (int side = 0; side < N_SIDES; side++) {
    for (int d = 0; d < DIM; d++) drive.side_velocity[side][d] = side_velocity_[side][d].evaluate(lmp);
    const std::string problem = what_is_wrong_with(side, drive.side_velocity[side][side / 2]);
    if (problem.empty()) continue;
    const std::string cause = "variable '" + side_velocity_[side][side / 2].variable() + "' for step " + std::to_string(lmp->update->ntimestep);
    throw OptionError(place_ + ": " + problem + " (" + cause + ")");
  }
  for (int d = 0; d < DIM; d++) {
    // A pressure that falls by DP over the length L pushes as a body force DP / (rho L).
    drive.body_force[d] = body_force_[d].evaluate(lmp) + pressure_drop_[d].evaluate(lmp) / (options_.density * box_.length[d]);
    drive.mean_velocity[d] = mean_velocity_[d].evaluate(lmp);
  }
  return drive;
}

Triple FluidScript::initial_velocity(LAMMPS_NS::LAMMPS *lmp) const
{
  return {initial_velocity_[0].evaluate(lmp), initial_velocity_[1].evaluate(lmp), 0.0};
}

}  // namespace swellflow
