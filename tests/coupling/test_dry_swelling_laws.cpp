// Every law of fix swell inside LIGGGHTS: its closed form, growth and shrinking, runs in parts, restarts, and a law after another.
#include <numbers>

#include "liggghts_plugins/objects/swelling_laws.h"
#include "swelling_scene.h"

using namespace swellflow_test;
using std::numbers::pi;

namespace {

constexpr const char *table_text = "# measured\ntime, ratio\n0, 1\n1, 1.2\n3, 1.5\n6, 1.6\n";

/// A law as the script says it, and its diameter for discs of 0.12 that begin it at their size of creation.
struct LawCase {
  std::string words;
  double (*diameter)(double t);
};

std::vector<LawCase> laws(const std::string &table)
{
  return {{"linear rate 0.01 max 0.15", [](double t) { return std::min(0.12 + 0.01 * t, 0.15); }},
          {"linear rate -0.01 min 0.09", [](double t) { return std::max(0.12 - 0.01 * t, 0.09); }},
          {"polynomial 0.12 0.02 -2e-3 until 4", [](double t) { t = std::min(t, 4.0); return 0.12 + 0.02 * t - 2e-3 * t * t; }},
          {"polynomial 1 -0.2 0.02 until 5 gives ratio", [](double t) { t = std::min(t, 5.0); return 0.12 * (1 - 0.2 * t + 0.02 * t * t); }},
          {"tanaka_fillmore final 0.18 tau 3", [](double t) { return 0.12 + 0.06 * swellflow::swelling_fraction(t / 3); }},
          {"tanaka_fillmore final 0.06 diffusivity 1e-4", [](double t) { return 0.12 - 0.06 * swellflow::swelling_fraction(t * pi * pi * 1e-4 / 0.0009); }},
          {"table " + table, [](double t) { return 0.12 * swellflow::MonotoneCurve({0, 1, 3, 6}, {1, 1.2, 1.5, 1.6}).value(t); }}};
}

}  // namespace

TEST(DrySwellingLaws, NaturalSizesAreThoseOfTheLaw)
{
  const TestFile table("law", table_text);
  for (const LawCase &law : laws(table.name)) {
    DryScene scene;
    make_four(scene, law.words);
    double t = 0.0;
    for (int steps : {0, 50, 100, 200, 300}) {
      scene.script("run " + std::to_string(steps) + "\n");
      t += 0.01 * steps;
      SCOPED_TRACE(law.words + " at " + std::to_string(t));
      expect_natural_diameter(scene, law.diameter(t), 1e-14);
    }
  }
}

TEST(DrySwellingLaws, RunsInPartsStepsOfAnotherLengthAndNewStepNumbersGoOn)
{
  const TestFile table("law_parts", table_text);
  for (const LawCase &law : laws(table.name)) {
    SCOPED_TRACE(law.words);
    DryScene scene;
    make_four(scene, law.words);
    scene.script("run 70\nrun 30\ntimestep 0.005\nrun 100\nreset_timestep 7\nrun 50\n");
    expect_natural_diameter(scene, law.diameter(1.75), 1e-14);
  }
}

TEST(DrySwellingLaws, ARestartGoesOn)
{
  const TestFile table("law_restart", table_text), file("law.restart");
  for (const LawCase &law : laws(table.name)) {
    SCOPED_TRACE(law.words);
    DryScene::State whole;
    {
      DryScene scene;
      make_four(scene, law.words);
      scene.script("run 150\nwrite_restart " + file.name + "\nrun 150\n");
      whole = scene.state();
    }
    DryScene scene;
    read_again(scene, file.name, springs_and_motion + ("fix grow all swell " + law.words) + "\ntimestep 0.01\nrun 150\n");
    expect_natural_diameter(scene, law.diameter(3.0), 1e-14);
    EXPECT_LT(largest_difference(scene.state(), whole), 1e-12);
  }
}

TEST(DrySwellingLaws, ALaterLawBeginsAtThePresentSize)
{
  const TestFile table("law_later", table_text);
  for (const LawCase &law : laws(table.name)) {
    SCOPED_TRACE(law.words);
    DryScene scene;
    make_four(scene, law.words);
    scene.script("run 100\nunfix grow\nrun 20\n");
    const double start = law.diameter(1.0);
    expect_natural_diameter(scene, start, 1e-14);
    scene.script("fix grow all swell tanaka_fillmore final 0.1 tau 2\nrun 100\n");
    expect_natural_diameter(scene, start + (0.1 - start) * swellflow::swelling_fraction(0.5), 1e-14);
    scene.script("unfix grow\nfix other all swell table " + table.name + "\nrun 100\n");
    const double second = start + (0.1 - start) * swellflow::swelling_fraction(0.5);
    expect_natural_diameter(scene, 1.2 * second, 1e-14);
    scene.script("unfix other\nfix grow all swell polynomial 1 0.1 until 10 gives ratio\nrun 100\n");
    expect_natural_diameter(scene, 1.1 * 1.2 * second, 1e-14);
  }
}

TEST(DrySwellingLaws, AnotherFixAfterARestartBeginsAtThePresentSize)
{
  const TestFile file("law_other.restart");
  {
    DryScene scene;
    make_four(scene, "linear rate 0.01 max 0.15");
    scene.script("run 100\nwrite_restart " + file.name + "\n");
  }
  DryScene scene;
  read_again(scene, file.name, std::string(springs_and_motion) + "fix new all swell linear rate 0.02 max 0.2\ntimestep 0.01\nrun 0\n");
  expect_natural_diameter(scene, 0.13, 1e-14);
  scene.script("run 100\n");
  expect_natural_diameter(scene, 0.15, 1e-14);
}

TEST(DrySwellingLaws, TheHydrogelGrowsAsPublished)
{
  for (const auto &[form, at_9_7_hours] : {std::pair{"printed", 16.3604859e-3}, {"reconstructed", 13.5038701e-3}}) {
    DryScene scene;
    scene.box("-0.015 0.015 -0.015 0.015", "f f p", "1e-3", "-1e-3 1e-3");
    // Without springs and motion: only natural sizes are asked for.
    scene.script("create_objects disk 0 0 diameter 3e-3 points 10 density 1500 cds 0.1\nfix grow all swell hydrogel " + std::string(form) +
                 "\ntimestep 10\nrun 3492\n");
    EXPECT_NEAR(natural_diameter(scene, 1), at_9_7_hours, 1e-10);
    scene.script("run 100\n");
    EXPECT_NEAR(natural_diameter(scene, 1), at_9_7_hours, 1e-10) << "the size stays";
  }
}

namespace {

/// Nine discs in a box that they fill, driven by gravity; they shrink and grow again.
void shrink_and_grow(DryScene &scene)
{
  scene.box("0 1 0 1");
  scene.script("create_objects lattice 3 3 origin 0.2 0.2 spacing 0.3 disk diameter 0.2 points 20 density 1500 cds 0.2\n"
               "fix springs all mass_spring stiffness 2000 restitution 0.5\nfix move all nve/cds\nfix flat all enforce2d\nfix g all gravity 0.3 vector 0.3 -1 0\n");
  int k = 0;
  for (const char *plane : {"xplane 0.0", "xplane 1.0", "yplane 0.0", "yplane 1.0"})
    scene.script("fix side" + std::to_string(k++) + " all wall/gran model hooke/stiffness tangential history primitive type 1 " + plane + " absolute_damping on\n");
  scene.script("fix grow all swell linear rate -0.1 min 0.08\ntimestep 1e-3\nrun 1300\n");
  EXPECT_NEAR(scene.fix("grow")->compute_scalar(), 0.08, 1e-15);
  scene.script("unfix grow\nfix grow all swell tanaka_fillmore final 0.2 tau 0.3\nrun 700\n");
}

}  // namespace

TEST(DrySwellingLaws, ShrinkingAndGrowingObjectsInContactAreTheSameOnAnyNumberOfRanks)
{
  DryScene together;
  shrink_and_grow(together);
  DryScene alone(MPI_COMM_SELF);
  shrink_and_grow(alone);
  EXPECT_LT(largest_difference(together.state(), alone.state()), 1e-9);
  for (const auto &[tag, state] : alone.state()) {
    EXPECT_GT(std::min(state[0], state[1]), 0.0) << tag;
    EXPECT_LT(std::max(state[0], state[1]), 1.0) << tag;
  }
}

namespace {

double total_mass(const DryScene &scene)
{
  double sum = 0.0;
  for (const auto &[tag, state] : scene.state()) sum += state[5];
  return sum;
}

}  // namespace

TEST(DrySwellingMass, DrinkingAddsTheWaterOfTheGrownArea)
{
  const double area = 4 * pi / 4 * 0.0144;
  DryScene scene;
  make_four(scene, "linear rate 0.1 max 0.24 mass drink water_density 1000");
  scene.script("run 0\n");
  EXPECT_NEAR(total_mass(scene), 1500 * area, 1e-9 * area * 1500);
  const auto before = scene.state();
  scene.script("run 120\n");
  EXPECT_NEAR(total_mass(scene), 1500 * area + 1000 * 3 * area, 1e-9 * area * 1500);
  for (const auto &[tag, state] : scene.state()) EXPECT_NEAR(state[5] / before.at(tag)[5], 3.0, 1e-12) << "each point has its share, atom " << tag;
  for (int i = scene.atom()->nlocal; i < scene.atom()->nlocal + scene.atom()->nghost; i++)
    EXPECT_DOUBLE_EQ(scene.atom()->rmass[i], 3.0 * scene.objects()->sizes()[i][FixObjects::MASS]) << "images too";
}

TEST(DrySwellingMass, DrinkingMatterOfTheSameDensityKeepsTheDensity)
{
  DryScene drinks, keeps;
  make_four(drinks, "tanaka_fillmore final 0.2 tau 1 mass drink water_density 1500");
  make_four(keeps, "tanaka_fillmore final 0.2 tau 1 mass constant_density");
  for (DryScene *scene : {&drinks, &keeps}) scene->script("run 150\n");
  EXPECT_LT(largest_difference(drinks.state(), keeps.state()), 1e-12);
}

TEST(DrySwellingMass, DriedMatterLosesTheWater)
{
  DryScene scene;
  make_four(scene, "linear rate -0.01 min 0.1 mass drink water_density 1000");
  scene.script("run 300\n");
  const double area = 4 * pi / 4 * 0.0144;
  EXPECT_NEAR(total_mass(scene), 1500 * area + 1000 * (100.0 / 144 - 1) * area, 1e-9 * area * 1500);
}
