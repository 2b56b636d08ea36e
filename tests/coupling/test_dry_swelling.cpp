// Growth inside LIGGGHTS: natural sizes by each law, what follows them, and the values that thermo shows.
#include <numbers>

#include "swelling_scene.h"

using namespace swellflow_test;
using std::numbers::pi;

namespace {

constexpr const char *disk = "create_objects disk 0.5 0.5 diameter 0.12 points 20 density 1500 cds 0.2\n";

void make(DryScene &scene, const std::string &swell, double step = 1e-2)
{
  scene.box("0 1 0 1");
  scene.script(std::string(disk) + "fix springs all mass_spring stiffness 10 restitution 0.1\nfix move all nve/cds\n" + swell);
  scene.script("timestep " + std::to_string(step) + "\n");
}

}  // namespace

TEST(DrySwelling, LinearGrowthEndsAtItsCeilingToRoundOff)
{
  DryScene scene;
  make(scene, "fix grow all swell linear rate 6e-4 max 0.18\n", 0.05);
  scene.script("run 0\n");
  expect_natural_diameter(scene, 0.12, 1e-16);
  scene.script("run 1000\n");
  expect_natural_diameter(scene, 0.15, 1e-15);
  scene.script("run 1000\n");
  expect_natural_diameter(scene, 0.18, 5e-17);
  scene.script("run 200\n");
  expect_natural_diameter(scene, 0.18, 5e-17);
  EXPECT_NEAR(scene.fix("grow")->compute_scalar(), 0.18, 5e-17);
}

TEST(DrySwelling, TheObjectFollowsItsNaturalSize)
{
  DryScene scene;
  make(scene, "fix grow all swell linear rate 6e-3 max 0.18\n");
  scene.script("run 0\n");
  EXPECT_NEAR(scene.fix("grow")->compute_vector(1), 0.12, 1e-12);
  scene.script("run 4000\n");
  LAMMPS_NS::Fix *fix = scene.fix("grow");
  EXPECT_NEAR(fix->compute_vector(0), 0.18, 1e-15);
  EXPECT_NEAR(fix->compute_vector(1), 0.18, 1e-6);
  EXPECT_NEAR(fix->compute_vector(2), 0.18, 1e-6);
  EXPECT_NEAR(fix->compute_vector(3), 1.0, 1e-3);
  EXPECT_NEAR(fix->compute_vector(4), 1.0, 1e-4);
  EXPECT_NEAR(fix->compute_vector(5), 20 * 0.18 * 0.18 / 8 * std::sin(2 * pi / 20), 1e-6);
  EXPECT_NEAR(fix->compute_vector(6), 1.5, 1e-12);
  EXPECT_NEAR(fix->compute_vector(7), 40.0, 1e-9);
  EXPECT_NEAR(fix->compute_vector(8), 40.0, 1e-9);
}

TEST(DrySwelling, VariablesGiveDiameterOrRatio)
{
  {
    DryScene scene;
    make(scene, "variable size equal 0.12+0.001*step\nfix grow all swell diameter v_size\n");
    scene.script("run 30\n");
    expect_natural_diameter(scene, 0.15, 1e-15);
  }
  DryScene scene;
  make(scene, "variable ratio equal 1+0.01*step\nfix grow all swell ratio v_ratio absorb no\n");
  scene.script("run 30\n");
  expect_natural_diameter(scene, 0.12 * 1.3, 1e-15);
}

TEST(DrySwelling, AVariableThatNeedsAllRanksIsEvaluatedOnAllToo)
{
  DryScene scene;
  scene.box("0 1 0 1");
  scene.script("create_objects disk 0.2 0.2 diameter 0.12 points 20 density 1500 cds 0.2\nfix springs all mass_spring stiffness 10\nfix move all nve/cds\n"
               "compute energy all ke\nvariable size equal 0.12+0*c_energy+0.001*step\nfix grow all swell diameter v_size\ntimestep 1e-3\nrun 30\n");
  EXPECT_NEAR(natural_diameter(scene, 1), 0.15, 1e-15);
}

TEST(DrySwelling, RunsInPartsAndStepsOfAnotherLengthGoOn)
{
  DryScene scene;
  make(scene, "fix grow all swell linear rate 1e-3 max 1.0\n");
  scene.script("run 500\nrun 500\n");
  expect_natural_diameter(scene, 0.13, 1e-15);
  scene.script("timestep 0.005\nrun 1000\n");
  expect_natural_diameter(scene, 0.135, 1e-15);
  scene.script("reset_timestep 0\nrun 1000\n");
  expect_natural_diameter(scene, 0.14, 1e-15);
}

TEST(DrySwelling, ALaterLawBeginsWhereTheEarlierOneEnded)
{
  DryScene scene;
  make(scene, "fix grow all swell linear rate 1e-3 max 1.0\n");
  scene.script("run 1000\nunfix grow\nrun 100\n");
  expect_natural_diameter(scene, 0.13, 1e-15);
  scene.script("fix grow all swell linear rate 2e-3 max 1.0\nrun 0\n");
  expect_natural_diameter(scene, 0.13, 1e-15);
  scene.script("run 500\n");
  expect_natural_diameter(scene, 0.14, 1e-15);
}

TEST(DrySwelling, ObjectsMadeLaterBeginTheirOwnGrowth)
{
  DryScene scene;
  make(scene, "fix grow all swell linear rate 1e-3 max 1.0\n");
  scene.script("run 1000\ncreate_objects disk 0.2 0.2 diameter 0.1 points 10 density 1500\nrun 1000\n");
  for (int i = 0; i < scene.atom()->nlocal; i++) {
    const double *point = scene.objects()->points()[i];
    EXPECT_NEAR(scene.objects()->sizes()[i][FixObjects::LAMBDA] * point[FixObjects::DIAMETER], scene.atom()->molecule[i] == 1 ? 0.14 : 0.11, 1e-15);
  }
}

TEST(DrySwelling, TwoLawsForTwoGroups)
{
  DryScene scene;
  scene.box("0 1 0 1");
  scene.script("create_objects lattice 2 1 origin 0.3 0.5 spacing 0.4 disk diameter 0.1 points 12 density 1000\n"
               "group a molecule 1\ngroup b molecule 2\nfix springs all mass_spring stiffness 1000\nfix move all nve/cds\n"
               "fix grow_a a swell linear rate 1e-2 max 0.11\nfix grow_b b swell linear rate 1e-2 max 0.12\ntimestep 1e-2\nrun 500\n");
  EXPECT_NEAR(scene.fix("grow_a")->compute_scalar(), 0.11, 1e-15);
  EXPECT_NEAR(scene.fix("grow_b")->compute_scalar(), 0.12, 1e-15);
}
