// Swelling slowed by load: an object between two walls stops when its contact pressure reaches the swelling pressure; a free one does not notice.
#include "liggghts_plugins/contact_forces.h"
#include "swelling_scene.h"

using namespace swellflow_test;

namespace {

constexpr double swelling_pressure = 10.0;

/// Two walls that hold object 1 only.
std::string fixes(const std::string &words, const std::string &motion = "nve/cds")
{
  return "group held molecule 1\nfix springs all mass_spring stiffness 400 restitution 0.05\nfix move all " + motion + "\nfix flat all enforce2d\n"
         "fix low held wall/gran model hooke/stiffness tangential history primitive type 1 yplane 0.42 absolute_damping on\n"
         "fix high held wall/gran model hooke/stiffness tangential history primitive type 1 yplane 0.58 absolute_damping on\n"
         "fix grow all swell linear rate 0.02 max 0.3 load 10" + words + "\ntimestep 1e-3\n";
}

/// Object 1 fits between the walls with a little room and lies across the periodic sides; object 2 is alone.
void make_squeezed(DryScene &scene, const std::string &words = "", const std::string &motion = "nve/cds")
{
  scene.box("0 1 0 1", "p f p", "0.01");
  scene.script("create_objects disk 0.02 0.5 diameter 0.1 points 16 density 1500 cds 0.2\n"
               "create_objects disk 0.6 0.2 diameter 0.1 points 16 density 1500 cds 0.2\n");
  scene.script(fixes(words, motion));
}

double elapsed(const DryScene &scene, int object, double time) { return time - column_of(scene, object, FixObjects::START_TIME); }

/// Of an object, on every rank. Collective.
double pressure(const DryScene &scene, int object)
{
  const LAMMPS_NS::ContactForces contacts(scene.lmp());
  double pressure = 0.0;
  for (const auto &one : scene.objects()->objects())
    if (scene.objects()->owns(one) && scene.atom()->molecule[one.hub] == object) pressure = contacts.pressure(one);
  MPI_Allreduce(MPI_IN_PLACE, &pressure, 1, MPI_DOUBLE, MPI_SUM, scene.lmp()->world);
  return pressure;
}

}  // namespace

TEST(DrySwellingLoad, ASqueezedObjectStopsAtTheSwellingPressureAndAFreeOneFollowsTheLaw)
{
  for (const char *motion : {"nve/cds", "nve/cds implicit"}) {
    SCOPED_TRACE(motion);
    DryScene scene;
    make_squeezed(scene, "", motion);
    scene.script("run 500\n");
    EXPECT_EQ(elapsed(scene, 1, 0.5), 0.5) << "no contact yet";
    EXPECT_NEAR(natural_diameter(scene, 1), 0.11, 1e-15);
    scene.script("run 7500\n");
    EXPECT_NEAR(pressure(scene, 1), swelling_pressure, 0.02 * swelling_pressure);
    EXPECT_EQ(pressure(scene, 2), 0.0);
    const double stopped = natural_diameter(scene, 1);
    EXPECT_LT(elapsed(scene, 1, 8.0), 6.0);
    EXPECT_NEAR(natural_diameter(scene, 2), 0.1 + 0.02 * 8.0, 1e-14);
    EXPECT_EQ(column_of(scene, 2, FixObjects::START_TIME), 0.0);
    EXPECT_NEAR(scene.fix("grow")->compute_vector(8), 0.5 * (8.0 + elapsed(scene, 1, 8.0)), 1e-12);
    scene.script("run 1000\n");
    EXPECT_NEAR(natural_diameter(scene, 1), stopped, 1e-3 * stopped);
  }
}

TEST(DrySwellingLoad, TheClockRunsAtTheSpeedThatThePressureLeaves)
{
  for (double exponent : {1.0, 2.5}) {
    DryScene scene;
    make_squeezed(scene, " exponent " + std::to_string(exponent));
    scene.script("run 1500\n");
    for (int k = 0; k < 5; k++) {
      const double p = pressure(scene, 1), before = elapsed(scene, 1, 1.5 + 1e-3 * k);
      ASSERT_GT(p, 0.5);
      scene.script("run 1\n");
      const double speed = (elapsed(scene, 1, 1.5 + 1e-3 * (k + 1)) - before) / 1e-3;
      EXPECT_NEAR(speed, std::pow(1.0 - p / swelling_pressure, exponent), 1e-9);
    }
  }
}

TEST(DrySwellingLoad, TensionDoesNotSpeedItUp)
{
  DryScene scene;
  make_squeezed(scene);
  // Outward forces on the points of object 2 that no spring gives: they count as contact, pull, and are far beyond the swelling pressure.
  scene.script("variable pull atom 50*(y-0.2)\nvariable pullx atom 50*(x-0.6)\ngroup free molecule 2\nfix pull free addforce v_pullx v_pull 0\n"
               "unfix grow\nfix grow all swell linear rate 0.02 max 0.3 load 10\nrun 300\n");
  EXPECT_LT(pressure(scene, 2), 0.0);
  EXPECT_EQ(elapsed(scene, 2, 0.3), 0.3);
}

TEST(DrySwellingLoad, IsTheSameOnAnyNumberOfRanks)
{
  DryScene together, alone(MPI_COMM_SELF);
  for (DryScene *scene : {&together, &alone}) {
    make_squeezed(*scene);
    scene->script("run 2500\n");
  }
  EXPECT_GT(pressure(alone, 1), 0.1 * swelling_pressure) << "the test asks something";
  EXPECT_LT(largest_difference(together.state(), alone.state()), 1e-10);
}

TEST(DrySwellingLoad, RestartsAndRunsInPartsAreOneRun)
{
  const TestFile file("load.restart");
  DryScene::State whole;
  {
    DryScene scene;
    make_squeezed(scene);
    scene.script("run 2500\n");
    whole = scene.state();
    EXPECT_GT(pressure(scene, 1), 0.1 * swelling_pressure);
  }
  {
    DryScene scene;
    make_squeezed(scene);
    scene.script("run 700\nrun 800\nwrite_restart " + file.name + "\nrun 1\nrun 999\n");
    EXPECT_LT(largest_difference(scene.state(), whole), 1e-12);
  }
  DryScene scene;
  read_again(scene, file.name, fixes("") + "run 1000\n");
  EXPECT_LT(largest_difference(scene.state(), whole), 1e-12);
}

TEST(DrySwellingLoad, AStepOfAnotherLengthNeverShrinksAnObjectThatHasStopped)
{
  DryScene scene;
  make_squeezed(scene, " exponent 4");
  scene.script("run 5000\n");
  double before = natural_diameter(scene, 1);
  for (const char *step : {"1e-3", "1e-4", "5e-4"}) {
    scene.script(std::string("timestep ") + step + "\nrun 50\n");
    EXPECT_GE(natural_diameter(scene, 1), before - 1e-15);
    before = natural_diameter(scene, 1);
  }
}
