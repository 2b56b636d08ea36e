// What fix fluid/ib makes of a script, told to a fluid that only listens: options, driving that varies, and when a fluid step begins.
#include "compute.h"
#include "fake_fluid.h"

using namespace swellflow_test;

namespace {

const std::string water = "fix water all fluid/ib cells 20 20 density 1000 viscosity 0.01 ";

void make_scene(FakeFluidScene &scene, const std::string &fluid_line, const std::string &boundary = "f f p")
{
  scene.box("0 1 0 1", boundary);
  scene.script("create_objects disk 0.5 0.5 diameter 0.2 points 10 density 1000 cds 0.1\nfix springs all mass_spring stiffness 1000\n"
               "fix move all nve/cds\ntimestep 1e-3\n" + water + fluid_line + "\n");
}

}  // namespace

TEST(FluidFix, OptionsReachTheFluid)
{
  FakeFluidScene scene;
  make_scene(scene, "every 6 cfl 0.4 slip xlo inflow yhi parabolic 0.1 -0.2 outflow ylo wall xhi velocity 0 0.3 advection bounded forcing multi 3 kernel peskin_2002");
  scene.script("run 1\n");
  const swellflow::FluidOptions &told = scene.talk.options;
  using Kind = swellflow::SideKind;
  const Kind kinds[] = {Kind::slip, Kind::wall, Kind::outflow, Kind::parabolic_inflow};
  for (int side = 0; side < 4; side++) EXPECT_EQ(told.sides[side], kinds[side]);
  EXPECT_EQ(told.dem_steps_per_fluid_step, 6);
  EXPECT_EQ(told.advection, swellflow::AdvectionScheme::bounded);
  EXPECT_EQ(told.forcing, swellflow::ForcingScheme::multi);
  EXPECT_EQ(told.forcing_loops, 3);
  EXPECT_EQ(told.kernel, "peskin_2002");
  EXPECT_EQ(scene.talk.drives[0].side_velocity[3], (swellflow::Triple{0.1, -0.2, 0.0}));
  EXPECT_EQ(scene.talk.drives[0].side_velocity[1], (swellflow::Triple{0.0, 0.3, 0.0}));
}

TEST(FluidFix, DrivingIsThatAtTheEndOfTheFluidStep)
{
  FakeFluidScene scene;
  scene.talk.dem_steps = {4};
  scene.script("variable lid equal time\nvariable count equal step\nvariable since equal elapsed\n");
  make_scene(scene, "every 4 wall yhi velocity v_lid 0 body_force v_count v_since");
  scene.script("run 8\nrun 6\n");
  ASSERT_EQ(scene.talk.drives.size(), 4u);
  for (int n = 0; n < 4; n++) {
    EXPECT_NEAR(scene.talk.drives[n].side_velocity[3][0], 4e-3 * (n + 1), 1e-15);
    EXPECT_EQ(scene.talk.drives[n].body_force[0], 4.0 * (n + 1));
    EXPECT_EQ(scene.talk.drives[n].body_force[1], n < 2 ? 4.0 * (n + 1) : 4.0 * (n - 1));
  }
  EXPECT_EQ(scene.lmp()->update->ntimestep, 14);
}

TEST(FluidFix, TimeIsRightAfterTheStepHasChanged)
{
  FakeFluidScene scene;
  scene.talk.dem_steps = {2};
  scene.script("variable lid equal time\n");
  make_scene(scene, "every 2 wall yhi velocity v_lid 0");
  scene.script("run 4\ntimestep 1e-2\nrun 4\n");
  EXPECT_NEAR(scene.talk.drives[1].side_velocity[3][0], 4e-3, 1e-15);
  EXPECT_NEAR(scene.talk.drives[2].side_velocity[3][0], 4e-3 + 2e-2, 1e-15);
}

TEST(FluidFix, TheFluidChoosesTheNumberOfDemSteps)
{
  FakeFluidScene scene;
  scene.talk.dem_steps = {3, 5, 1};
  scene.script("variable count equal step\n");
  make_scene(scene, "every 6 cfl 0.5 body_force v_count 0");
  scene.script("run 12\n");  // 3 + 5 + 1 + 3
  EXPECT_EQ(scene.talk.options.cfl, 0.5);
  EXPECT_EQ(scene.talk.options.dem_steps_per_fluid_step, 6);
  EXPECT_EQ(scene.talk.begun, (std::vector<int>{3, 5, 1, 3}));
  EXPECT_EQ(scene.talk.received.size(), 4u);
  const double ends[] = {3, 8, 9, 12};
  for (int n = 0; n < 4; n++) EXPECT_EQ(scene.talk.drives[n].body_force[0], ends[n]);
}

/// Where there is a choice, no fluid step reaches beyond the end of a run, or a restart file; the last two before it are of a length.
TEST(FluidFix, ChosenStepsEndWithTheRun)
{
  FakeFluidScene scene;
  scene.talk.dem_steps = {5};
  make_scene(scene, "every 6 cfl 0.5");
  scene.script("run 4\nrun 13\nrun 10\n");
  EXPECT_EQ(scene.talk.begun, (std::vector<int>{4, 5, 4, 4, 5, 5}));
  scene.talk.begun.clear();
  const std::string file = "chosen_" + std::to_string(ranks()) + ".restart";
  scene.script("restart 9 " + file + " " + file + "\nrun 9\n");  // from step 27; a file at 36
  EXPECT_EQ(scene.talk.begun, (std::vector<int>{5, 4}));
  MPI_Barrier(MPI_COMM_WORLD);
  if (rank() == 0) std::remove(file.c_str());
}

TEST(FluidFix, PressureFallsOverThePeriodicBox)
{
  FakeFluidScene scene;
  scene.script("units si\ndimension 2\natom_style hybrid granular molecular\nboundary p f p\nnewton off\ncommunicate single vel yes\n"
               "region box block 0 2 0 1 -0.02 0.02 units box\ncreate_box 1 box\n");
  scene.script("variable g equal 0.25\nvariable u0 equal 0.5\n" + water + "body_force v_g 0.5 pressure_drop 100 0 initial_velocity v_u0 0.125 slip ylo\nrun 1\n");
  ASSERT_EQ(scene.talk.drives.size(), 1u);
  EXPECT_NEAR(scene.talk.drives[0].body_force[0], 0.25 + 100.0 / (1000.0 * 2.0), 1e-15);
  EXPECT_EQ(scene.talk.drives[0].body_force[1], 0.5);
  EXPECT_EQ(scene.talk.options.initial_velocity, (swellflow::Triple{0.5, 0.125, 0.0}));
  using Kind = swellflow::SideKind;
  const Kind kinds[] = {Kind::periodic, Kind::periodic, Kind::slip, Kind::wall};
  for (int side = 0; side < 4; side++) EXPECT_EQ(scene.talk.options.sides[side], kinds[side]);
}

/// A variable is evaluated for the end of the fluid step with the values of its beginning: nobody may take these for those of the end.
TEST(FluidFix, ValuesThatAVariableAskedForAreNotThoseOfItsStep)
{
  const auto values_at_the_end = [](const std::string &force) {
    FakeFluidScene scene;
    scene.talk.dem_steps = {4};
    scene.script("variable nothing equal 0*(f_springs[1]+c_speed+f_grow[5])\ncompute speed all ke\n");
    scene.box("0 1 0 1");
    scene.script("create_objects disk 0.5 0.5 diameter 0.2 points 10 density 1000 cds 0.1\nfix springs all mass_spring stiffness 1000\n"
                 "fix grow all swell linear rate 1 max 0.3\nfix move all nve/cds\ntimestep 1e-3\n" + water + "every 4 body_force " + force + " 0\nrun 8\n");
    LAMMPS_NS::Modify &modify = *scene.lmp()->modify;
    EXPECT_NE(modify.compute[modify.find_compute("speed")]->invoked_scalar, scene.lmp()->update->ntimestep);
    return std::array<double, 2>{scene.value("springs", 1), scene.value("grow", 5)};
  };
  EXPECT_EQ(values_at_the_end("v_nothing"), values_at_the_end("0"));
}

TEST(FluidFix, ShowsItsValuesInOrder)
{
  FakeFluidScene scene;
  make_scene(scene, "every 1");
  scene.script("run 1\n");
  EXPECT_EQ(scene.fix("water")->size_vector, 21);
  for (int n = 10; n <= 21; n++) EXPECT_EQ(scene.value("water", n), n - 3.0);
}
