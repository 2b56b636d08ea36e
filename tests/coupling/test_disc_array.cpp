// Flow through the square array of held discs: its drag against the series of Sangani & Acrivos, and what that drag must not depend on.
#include "array_scene.h"

using namespace swellflow_test;

namespace {

/// F / (mu U) at a solid fraction of 0.1: Sangani & Acrivos, Int. J. Multiphase Flow 8 (1982).
constexpr double exact_drag = 24.83168;

const std::string stream = "mean_velocity x 1 mean_velocity y 0", no_stream = "mean_velocity x 0 mean_velocity y 0";

}  // namespace

// What drives the fluid, all of it in the box, is what the disc feels.
TEST(DiscArray, DragIsTheDrivingForceAndThatOfTheSeries)
{
  ArrayScene scene(DiscArray{});
  scene.run_for(0.4);
  EXPECT_NEAR(scene.drag(), scene.water(13), 1e-6 * scene.drag());
  EXPECT_NEAR(scene.disc(2), 0.0, 1e-9);
  EXPECT_NEAR(scene.disc(3), 0.0, 1e-9);
  EXPECT_NEAR(scene.water(11), 1.0, 1e-6);
  EXPECT_NEAR(scene.water(12), 0.0, 1e-9);
  EXPECT_NEAR(scene.drag(), exact_drag, 0.015 * exact_drag);
}

// With gaps of one cell the drag creeps on towards 25.07, the sooner the smaller the step, as forces that alternate from marker to marker build up.
TEST(DiscArray, DragDoesNotDependOnTheFluidStep)
{
  double least = 1e300, most = 0.0;
  for (const double z : {0.25, 1.0, 4.0, 16.0}) {
    DiscArray array;
    array.z = z;
    ArrayScene scene(array);
    scene.run_for(z > 4.0 ? 0.4 : 0.1);
    least = std::min(least, scene.drag());
    most = std::max(most, scene.drag());
  }
  EXPECT_LT(most - least, 0.005 * least);
}

TEST(DiscArray, EachKernelGivesTheDrag)
{
  for (const std::string kernel : {"roma_1999", "peskin_2002", "yang_2009", "gruninger_2025"}) {
    DiscArray array;
    array.fluid += " kernel " + kernel;
    ArrayScene scene(array);
    scene.run_for(0.2);
    EXPECT_NEAR(scene.drag(), exact_drag, 0.015 * exact_drag) << kernel;
  }
}

// Moved at -U through a fluid that rests in the mean, across the periodic side: 0.17 and 0.11 % less. The drag of a moving disc is its mean over a way of one cell.
// With a step twice as long, in which the disc goes a twelfth of a cell, it is 0.9 and 0.7 % less.
TEST(DiscArray, MovedDiscHasTheDragOfTheHeldOne)
{
  for (const std::string kernel : {"roma_1999", "yang_2009"}) {
    DiscArray array;
    array.z = 2.0;
    array.fluid = stream + " kernel " + kernel;
    ArrayScene held(array);
    held.run_for(0.2);
    array.x = 0.25;
    array.motion = "prescribed velocity -1 0";
    array.fluid = no_stream + " kernel " + kernel;
    ArrayScene moved(array);
    const int steps_in_a_cell = 24;
    moved.run(13 * steps_in_a_cell);
    double sum = 0.0;
    for (int s = 0; s < steps_in_a_cell; s++) {
      moved.run(1);
      sum += moved.drag();
    }
    EXPECT_NEAR(sum / steps_in_a_cell, held.drag(), 0.005 * held.drag()) << kernel;
    EXPECT_NEAR(moved.water(11), 0.0, 1e-4) << kernel;
    EXPECT_LT(moved.water(8), 1e-12) << kernel;
  }
}

namespace {

constexpr const char *schemes[] = {"direct", "multi 5", "implicit"};

/// Mean slip over the later steps of a flow that is driven to and fro. What drives the fluid it keeps or gives to the points, at the latest in the next step.
double slip_in_a_pulsating_flow(const std::string &scheme)
{
  DiscArray array;
  array.z = 1.0;
  array.variables = "variable g equal 50*sin(10*PI*time)\n";
  array.fluid = "body_force v_g 0 advection none forcing " + scheme;
  ArrayScene scene(array);
  scene.run(80);
  const double dt = scene.lmp()->update->dt, before = scene.water(11);
  double sum = 0.0, budget = 0.0, exchanged = 0.0;
  for (int s = 0; s < 60; s++) {
    scene.run(1);
    sum += scene.water(1) / 60;
    budget += dt * (scene.water(13) - scene.water(6));
    exchanged += dt * std::abs(scene.water(6));
    EXPECT_LT(scene.water(8), 1e-12) << scheme;
  }
  EXPECT_NEAR(scene.water(11) - before, budget, 1e-5 * exchanged) << scheme;
  return sum;
}

double slip_in_a_steady_flow(const std::string &scheme)
{
  DiscArray array;
  array.fluid += " kernel yang_2009 forcing " + scheme;
  ArrayScene scene(array);
  scene.run_for(0.2);
  EXPECT_LT(scene.water(8), 1e-12) << scheme;
  return scene.water(1);
}

}  // namespace

// The projection, after the forcing, leaves a slip of its own in unsteady flow.
TEST(DiscArray, CloserForcingSlipsLess)
{
  double pulsating[3], steady[3];
  for (int k = 0; k < 3; k++) {
    pulsating[k] = slip_in_a_pulsating_flow(schemes[k]);
    steady[k] = slip_in_a_steady_flow(std::string(schemes[k]) + " projections 1");
  }
  EXPECT_LT(pulsating[1], 0.98 * pulsating[0]);
  EXPECT_LT(pulsating[2], pulsating[1]);
  EXPECT_LT(steady[1], 0.9 * steady[0]);
  EXPECT_LT(steady[2], 0.6 * steady[1]);
}
