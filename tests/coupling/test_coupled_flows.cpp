// Kinds of flow, by script: a disc on the corner of a periodic box, free objects with several passes, steps of changing length, flow along a channel and through a box.
#include "array_scene.h"

using namespace swellflow_test;

namespace {

double drag_after_a_hundred_steps(double cells_aside, MPI_Comm comm)
{
  DiscArray array;
  array.x += cells_aside / ArrayScene::cells;
  array.y -= cells_aside / ArrayScene::cells;
  ArrayScene scene(array, comm);
  scene.run(100);
  EXPECT_NEAR(scene.disc(2), 0.0, 1e-9);
  EXPECT_LT(scene.water(3), 1e-9);
  return scene.drag();
}

}  // namespace

TEST(CoupledFlows, ADiscOnTheCornerOfAPeriodicBoxIsOneInItsMiddle)
{
  const double expected = drag_after_a_hundred_steps(0.0, MPI_COMM_SELF);
  EXPECT_GT(expected, 20.0);
  EXPECT_NEAR(drag_after_a_hundred_steps(0.0, MPI_COMM_WORLD), expected, 1e-9 * expected);
  EXPECT_NEAR(drag_after_a_hundred_steps(23.0, MPI_COMM_WORLD), expected, 1e-9 * expected);
}

// ---- forcing schemes -------------------------------------------------------------------------------------------------------------------------

// What more than one pass adds the points receive a step late. Twenty passes are the harder test with markers 0.75 cells apart, where forces that alternate from
// marker to marker are large.
TEST(CoupledFlows, FreeObjectsBearSeveralPasses)
{
  for (const std::string scheme : {"direct", "multi 5", "multi 20"}) {
    CoupledScene scene;
    scene.cavity(2, 0.2, 1500.0, 1000.0, 50, 4, 5e-3);
    scene.script("fix water all fluid/ib cells 50 50 density 1000 viscosity 0.01 every 4 wall yhi velocity 0.1 0 forcing " + scheme + "\n");
    for (int round = 0; round < 10; round++) {
      scene.script("run 80\n");
      EXPECT_LT(scene.water(8), 1e-12) << "momentum, " << scheme;
    }
    EXPECT_LT(scene.fastest_point(), 0.1) << scheme;
    EXPECT_GT(scene.fastest_point(), 0.01) << scheme;
    EXPECT_LT(scene.water(1), 1e-4) << "mean slip, " << scheme;
  }
}

// ---- steps of changing length ----------------------------------------------------------------------------------------------------------------

namespace {

constexpr double dem_step = 1e-3;

/// Four objects under a lid that speeds up to 1, in as many steps of LIGGGHTS as given; fix fluid/ib with these steps.
struct Speeding : CoupledScene {
  Speeding(int steps, const std::string &fluid_steps)
  {
    script("variable u equal 0.1+0.9*time/" + std::to_string(dem_step * steps) + "\n");
    cavity(2, 0.2, 1500.0, 1000.0, 50, 4, 4 * dem_step);
    script("fix water all fluid/ib cells 50 50 density 1000 viscosity 0.01 wall yhi velocity v_u 0 " + fluid_steps + "\nrun 0\n");
    start = state();
  }
  State start;
};

/// Largest difference of a point's place, over the largest way of any point.
double difference_of_ways(const Speeding &one, const Speeding &other)
{
  double difference = 0.0, way = 0.0;
  const auto a = one.state(), b = other.state();
  for (const auto &[tag, values] : a)
    for (int d = 0; d < 2; d++) {
      difference = std::max(difference, std::abs(values[d] - b.at(tag)[d]));
      way = std::max(way, std::abs(values[d] - one.start.at(tag)[d]));
    }
  return difference / way;
}

}  // namespace

TEST(CoupledFlows, StepsKeepBelowTheCflNumber)
{
  const int steps = ranks() == 1 ? 2000 : 400, most = 20;
  Speeding scene(steps, "every 20 cfl 0.3");
  double longest = 0.0, shortest = 1.0, largest_cfl = 0.0;
  for (int s = 0; s < steps; s++) {
    scene.script("run 1 pre no post no\n");
    const double fluid_step = scene.water(10);
    if (fluid_step == 0.0) continue;  // none is whole yet
    EXPECT_NEAR(fluid_step / dem_step, std::round(fluid_step / dem_step), 1e-9);
    longest = std::max(longest, fluid_step);
    shortest = s > 200 ? std::min(shortest, fluid_step) : 1.0;
    largest_cfl = std::max(largest_cfl, scene.water(4));
    EXPECT_LT(scene.water(8), 1e-12);
  }
  EXPECT_LT(largest_cfl, 0.3 * 1.2);
  EXPECT_GT(largest_cfl, 0.2);
  EXPECT_LT(shortest, 0.5 * most * dem_step);
  EXPECT_GT(longest, 1.5 * shortest);
  EXPECT_LT(longest, (most + 0.5) * dem_step);
  if (ranks() > 1) return;
  Speeding fixed(steps, "every 4");
  fixed.script("run " + std::to_string(steps) + "\n");
  EXPECT_LT(difference_of_ways(fixed, scene), 0.02);
  EXPECT_NEAR(scene.water(5), fixed.water(5), 0.02 * fixed.water(5));
}

// ---- channels --------------------------------------------------------------------------------------------------------------------------------

// U = dp H^2 / (12 mu L). On cells the profile is the exact one plus h^2 / 8 of its curvature, and its sum exceeds the integral by h^2 / 24 of the change of slope:
// together by 2 (h / H)^2 of U.
TEST(CoupledFlows, PressureDropDrivesPoiseuilleFlow)
{
  for (const bool along_x : {true, false}) {
    CoupledScene scene;
    scene.script("units si\ndimension 2\natom_style hybrid granular molecular\natom_modify map array\nnewton off\ncommunicate single vel yes\n");
    scene.script(std::string(along_x ? "boundary p f p\nregion box block 0 0.5 0 2 -0.5 0.5 units box\n" : "boundary f p p\nregion box block 0 2 0 0.5 -0.5 0.5 units box\n") +
                 "create_box 1 box\n");
    scene.script(std::string("fix water all fluid/ib density 1000 viscosity 0.5 cells ") + (along_x ? "16 64 pressure_drop 60 0" : "64 16 pressure_drop 0 60") + "\n");
    scene.script("timestep 0.02\nrun 1000\n");
    const double poiseuille = 60.0 * 2 * 2 / (12 * 500.0 * 0.5);
    const int direction = along_x ? 0 : 1;
    EXPECT_NEAR(scene.water(13 + direction), 60.0 / 0.5, 1e-9);
    EXPECT_NEAR(scene.water(11 + direction), poiseuille, 0.005 * poiseuille);
    EXPECT_NEAR(scene.water(11 + direction), poiseuille * (1 + 2.0 / (64 * 64)), 1e-6 * poiseuille);
    EXPECT_NEAR(scene.water(12 - direction), 0.0, 1e-12);
  }
}

// ---- through the box -------------------------------------------------------------------------------------------------------------------------

namespace {

struct Through {
  double drag, lift, energy;
};

Through flow_past_a_disc(MPI_Comm comm)
{
  CoupledScene scene(comm);
  scene.box("0 2 0 1");
  scene.script("create_objects disk 0.7 0.45 diameter 0.25 points 26 density 1\nfix disc all held\n"
               "fix water all fluid/ib cells 64 32 density 1 viscosity 0.02 inflow xlo uniform 1 0 outflow xhi slip ylo slip yhi initial_velocity 1 0\n"
               "timestep 0.01\n");
  for (int round = 0; round < 10; round++) {
    scene.script("run 20\n");
    EXPECT_LT(scene.water(3), 1e-9) << "divergence";
    EXPECT_NEAR(scene.water(11), 1.0, 1e-4) << "mean velocity: every section passes what comes in";
  }
  return {scene.fix("disc")->compute_vector(0), scene.fix("disc")->compute_vector(1), scene.water(5)};
}

}  // namespace

TEST(CoupledFlows, ADiscInAStreamThroughTheBox)
{
  const Through alone = flow_past_a_disc(MPI_COMM_SELF), parallel = flow_past_a_disc(MPI_COMM_WORLD);
  EXPECT_GT(alone.drag, 0.0);
  EXPECT_NEAR(parallel.drag, alone.drag, 1e-9 * alone.drag);
  EXPECT_NEAR(parallel.lift, alone.lift, 1e-9 * alone.drag);
  EXPECT_NEAR(parallel.energy, alone.energy, 1e-9 * alone.energy);
}
