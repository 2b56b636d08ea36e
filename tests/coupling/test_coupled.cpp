// Soft objects in the fluid: stability over density ratios and sub-steps, exact exchange of momentum, independence of the ranks.
#include "coupled_scene.h"
#include "liggghts_plugins/fluid_columns.h"

#include "fix_property_atom.h"

using namespace swellflow_test;
using swellflow::FluidImpulse;

namespace {

constexpr double fluid_density = 1000.0, lid = 0.1;

struct Stability : testing::TestWithParam<std::tuple<double, int>> {};

// Undamped springs: whatever feeds them would show within 1000 steps of 5e-3.
TEST_P(Stability, SoftObjectsFollowTheFlowForAThousandSteps)
{
  const auto [ratio, every] = GetParam();
  CoupledScene scene;
  const int fluid_steps = ranks() == 1 ? 1000 : 100;  // several ranks are a matter of bookkeeping, not of stability
  scene.cavity(2, 0.2, ratio * fluid_density, 1000.0, 50, every, 5e-3);
  scene.script("run " + std::to_string(fluid_steps * every) + "\n");
  EXPECT_LT(scene.fastest_point(), lid);
  EXPECT_LT(scene.water(1), 0.01 * lid) << "mean slip";
  EXPECT_LT(scene.water(3), 1e-10) << "divergence";
  EXPECT_LT(scene.water(8), 1e-12) << "momentum";
}
INSTANTIATE_TEST_SUITE_P(DensityRatioAndSubSteps, Stability,
                         testing::Combine(testing::Values(1.05, 1.5, 3.0), testing::Values(1, 10, 100)));

// Objects vibrate when they meet; what comes back from the fluid inside must not feed that. Without the smoothing of its acceleration the slip is 100 times as large.
TEST(Contact, VibrationsAreNotFed)
{
  CoupledScene scene;
  scene.cavity(4, 0.15, 1050.0, 1e4, 80, 10, 5e-3);
  scene.script("run " + std::to_string(ranks() == 1 ? 40000 : 1000) + "\n");
  EXPECT_LT(scene.fastest_point(), lid);
  EXPECT_LT(scene.water(1), 0.01 * lid) << "mean slip";
}

double **property(const CoupledScene &scene, const char *name)
{
  return static_cast<LAMMPS_NS::FixPropertyAtom *>(scene.fix(name))->array_atom;
}

// With no contact, what changes the momentum of an object is the fluid's law alone, which the fluid inside is part of: springs cancel.
TEST(Momentum, PointsChangeByTheImpulsesThatAreBooked)
{
  CoupledScene scene;
  scene.cavity(2, 0.2, 1500.0, 1000.0, 50, 4, 5e-3);
  scene.script("run 400\n");
  const auto momentum = [&] {
    std::array<double, 2> sum{};
    for (int i = 0; i < scene.atom()->nlocal; i++)
      for (int d = 0; d < 2; d++) sum[d] += scene.atom()->rmass[i] * scene.atom()->v[i][d];
    MPI_Allreduce(MPI_IN_PLACE, sum.data(), 2, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
    return sum;
  };
  const auto before = momentum();
  scene.script("run 4\n");
  const auto after = momentum();
  std::array<double, 2> impulse{};
  for (int i = 0; i < scene.atom()->nlocal; i++)
    for (int d = 0; d < 2; d++) impulse[d] += property(scene, FluidImpulse::NAME)[i][d];
  MPI_Allreduce(MPI_IN_PLACE, impulse.data(), 2, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
  for (int d = 0; d < 2; d++) EXPECT_NEAR(after[d] - before[d], impulse[d], 1e-11 * std::abs(before[d]) + 1e-14);
}

/// Nine growing objects, three of them on the border between two slabs, and some on every border between four.
void swelling_cavity(CoupledScene &scene, const std::string &processors)
{
  scene.cavity(3, 0.19, 1500.0, 1000.0, 64, 2, 5e-3, processors);
  scene.script("fix grow all swell linear rate 0.04 max 0.3\nrun 400\n");  // to 0.23, where all touch
}

double difference_from_one_rank(const std::string &processors)
{
  CoupledScene parallel, alone(MPI_COMM_SELF);
  swelling_cavity(parallel, processors);
  swelling_cavity(alone, "* * 1");
  EXPECT_LT(parallel.fix("grow")->compute_vector(3), 1.2) << "aspect ratio";
  EXPECT_GT(parallel.fix("grow")->compute_vector(3), 1.001) << "they must touch for the test to mean something";
  return largest_difference(parallel.state(), alone.state());
}

TEST(Ranks, AgreeOverTwoHundredFluidSteps)
{
  EXPECT_LT(difference_from_one_rank("* * 1"), 1e-9);
  EXPECT_LT(difference_from_one_rank("1 * 1"), 1e-9);
  EXPECT_LT(difference_from_one_rank("* 1 1"), 1e-9);
}

TEST(Script, TwoRunsEqualOne)
{
  CoupledScene once, twice;
  for (CoupledScene *scene : {&once, &twice}) scene->cavity(2, 0.2, 1500.0, 1000.0, 32, 4, 5e-3);
  once.script("run 80\n");
  twice.script("run 38\nrun 42\n");  // the first ends within a fluid step
  EXPECT_LT(largest_difference(once.state(), twice.state()), 1e-13);
}

TEST(Script, TheFluidCanBeTakenOutAndPutBack)
{
  CoupledScene scene;
  scene.cavity(2, 0.2, 1500.0, 1000.0, 32, 4, 5e-3);
  scene.script("run 40\nunfix water\nrun 40\n");
  EXPECT_LT(scene.lmp()->modify->find_fix("fluid_law"), 0);
  scene.script("fix water all fluid/ib cells 32 32 density 1000 viscosity 0.01 every 4\nrun 40\n");
  EXPECT_LT(scene.water(8), 1e-12);
}

TEST(Script, TheFluidCanBeIssuedAgainUnderItsId)
{
  CoupledScene scene;
  scene.cavity(2, 0.2, 1500.0, 1000.0, 32, 4, 5e-3);
  scene.script("run 40\nfix water all fluid/ib cells 32 32 density 1000 viscosity 0.01 every 4\nrun 40\n");
  EXPECT_LT(scene.water(8), 1e-12);
}

TEST(Script, ValuesAreThoseOfTheLastWholeFluidStep)
{
  CoupledScene scene;
  scene.cavity(2, 0.2, 1500.0, 1000.0, 32, 4, 5e-3);
  scene.script("run 40\n");
  std::array<double, 9> whole;
  for (int n = 1; n <= 9; n++) whole[n - 1] = scene.water(n);
  scene.script("run 2\n");
  for (int n : {1, 2, 3, 6, 7, 8}) EXPECT_EQ(scene.water(n), whole[n - 1]) << n;
}

TEST(Script, AFluidAloneNeedsNoPairStyle)
{
  CoupledScene scene;
  scene.script("units si\ndimension 2\natom_style hybrid granular molecular\natom_modify map array\nboundary f f p\nnewton off\n"
               "communicate single vel yes\nregion box block 0 1 0 1 -0.01 0.01 units box\ncreate_box 1 box\n"
               "fix water all fluid/ib cells 32 32 density 1000 viscosity 0.01 wall yhi velocity 0.1 0\ntimestep 0.01\nrun 20\n");
  EXPECT_GT(scene.water(5), 0.0);
}

// Objects of the fluid's own density feel no weight; gravity never enters the fluid.
TEST(Gravity, BuoyancyTakesTheFluidsWeightAway)
{
  for (double density : {1000.0, 1500.0}) {
    CoupledScene scene;
    scene.cavity(1, 0.3, density, 1000.0, 50, 4, 5e-3);
    scene.script("unfix water\nfix water all fluid/ib cells 50 50 density 1000 viscosity 0.01 every 4\n");
    scene.script("fix weight all gravity 0.1 vector 0 -1 0\nrun 400\n");
    double sinking = 0.0;
    for (int i = 0; i < scene.atom()->nlocal; i++) sinking = std::min(sinking, scene.atom()->v[i][1]);
    MPI_Allreduce(MPI_IN_PLACE, &sinking, 1, MPI_DOUBLE, MPI_MIN, MPI_COMM_WORLD);
    if (density == 1000.0)
      EXPECT_NEAR(sinking, 0.0, 1e-10);
    else
      EXPECT_LT(sinking, -1e-3);
  }
}

}  // namespace
