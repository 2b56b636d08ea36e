// Objects that differ in speed and final size of their growth.
#include "liggghts_plugins/objects/random_factor.h"
#include "swelling_scene.h"

using namespace swellflow_test;
using swellflow::Purpose;

namespace {

constexpr const char *many_discs = "create_objects lattice 16 16 origin 0.04 0.04 spacing 0.06 disk diameter 0.03 points 6 density 1500 cds 0.1\n";

void make_many(DryScene &scene, const std::string &words)
{
  scene.box("0 1 0 1", "f f p", "0.005");
  scene.script(std::string(many_discs) + springs_and_motion + "fix grow all swell " + words + "\ntimestep 1e-3\n");
}

}  // namespace

TEST(DrySwellingScatter, RunsTheClockFasterAndTheGrowthFarther)
{
  DryScene scene;
  make_four(scene, "polynomial 0.12 0.02 -1e-3 until 2 scatter 0.2 0.1 seed 5");
  for (double t : {0.5, 1.0, 1.5, 2.0, 2.5, 3.0, 3.5}) {
    scene.script("run 50\n");
    for (int object = 1; object <= 4; object++) {
      const double rate = lognormal_factor(Purpose::swelling_rate, 0.2, 5, object), size = lognormal_factor(Purpose::swelling_size, 0.1, 5, object);
      const double own_time = std::min(rate * t, 2.0), grown = 0.02 * own_time - 1e-3 * own_time * own_time;
      EXPECT_EQ(column_of(scene, object, FixObjects::RATE_FACTOR), rate);
      EXPECT_EQ(column_of(scene, object, FixObjects::SIZE_FACTOR), size);
      EXPECT_NEAR(natural_diameter(scene, object), 0.12 + size * grown, 1e-14);
    }
  }
}

TEST(DrySwellingScatter, HasTheMeanAndTheSpreadAskedFor)
{
  DryScene scene;
  make_many(scene, "linear rate 1e-3 max 0.04 scatter 0.3 0.1 seed 1");
  scene.script("run 0\n");
  double sums[4] = {}, n = 0.0;
  for (int object = 1; object <= 256; object++, n++) {
    const double rate = column_of(scene, object, FixObjects::RATE_FACTOR), size = column_of(scene, object, FixObjects::SIZE_FACTOR);
    sums[0] += rate, sums[1] += rate * rate, sums[2] += size, sums[3] += size * size;
  }
  const double rate = sums[0] / n, size = sums[2] / n;
  EXPECT_NEAR(rate, 1.0, 4 * 0.3 / 16);
  EXPECT_NEAR(size, 1.0, 4 * 0.1 / 16);
  EXPECT_NEAR(std::sqrt(sums[1] / n - rate * rate), 0.3, 0.06);
  EXPECT_NEAR(std::sqrt(sums[3] / n - size * size), 0.1, 0.02);
}

TEST(DrySwellingScatter, IsTheSameOnAnyNumberOfRanks)
{
  const std::string words = "tanaka_fillmore final 0.04 tau 0.1 scatter 0.3 0.2 seed 9";
  DryScene together, alone(MPI_COMM_SELF);
  for (DryScene *scene : {&together, &alone}) {
    make_many(*scene, words);
    scene->script("run 100\n");
  }
  const auto a = together.state(), b = alone.state();
  for (const auto &[tag, state] : a) ASSERT_EQ(state[4], b.at(tag)[4]) << "radius of atom " << tag;
  EXPECT_LT(largest_difference(a, b), 1e-12);
}

TEST(DrySwellingScatter, GoesOnAfterARestartAndStaysWithinALaw)
{
  const TestFile file("scatter.restart");
  const std::string grow = "fix grow all swell linear rate 0.01 max 0.2 scatter 0.3 0.2 seed 3\n";
  DryScene::State whole;
  {
    DryScene scene;
    make_four(scene, "linear rate 0.01 max 0.2 scatter 0.3 0.2 seed 3");
    scene.script("run 100\nwrite_restart " + file.name + "\nrun 100\n");
    whole = scene.state();
  }
  DryScene scene;
  read_again(scene, file.name, springs_and_motion + grow + "timestep 0.01\nrun 60\nrun 40\n");
  EXPECT_LT(largest_difference(scene.state(), whole), 1e-12);
  EXPECT_EQ(column_of(scene, 2, FixObjects::RATE_FACTOR), lognormal_factor(Purpose::swelling_rate, 0.3, 3, 2));
}

TEST(DrySwellingScatter, ALaterLawDrawsAnew)
{
  DryScene scene;
  make_four(scene, "linear rate 0.01 max 0.2 scatter 0.3 0.2 seed 3");
  scene.script("run 100\nunfix grow\nfix grow all swell linear rate 0.01 max 0.3 scatter 0.3 0.2 seed 4\nrun 0\n");
  EXPECT_EQ(column_of(scene, 2, FixObjects::RATE_FACTOR), lognormal_factor(Purpose::swelling_rate, 0.3, 4, 2));
  scene.script("unfix grow\nfix grow all swell linear rate 0.01 max 0.3\nrun 0\n");
  EXPECT_EQ(column_of(scene, 2, FixObjects::RATE_FACTOR), 1.0);
}

TEST(DrySwellingScatter, OfTheSizeWorksWithVariablesToo)
{
  DryScene scene;
  scene.script("variable size equal 0.12+0.001*step\n");
  make_four(scene, "diameter v_size scatter 0 0.2 seed 3");
  scene.script("run 30\n");
  for (int object = 1; object <= 4; object++)
    EXPECT_NEAR(natural_diameter(scene, object), 0.12 + 0.03 * lognormal_factor(Purpose::swelling_size, 0.2, 3, object), 1e-14);
}
