// A clock that runs faster than the simulation: the law with its rates multiplied, whatever else acts on it; and the measure of how slow swelling is beside contacts.
#include "liggghts_plugins/contact_forces.h"
#include "swelling_scene.h"

using namespace swellflow_test;

namespace {

/// The same law by a fast clock, and with fast rates.
struct Pair {
  std::string by_clock, by_rates;
};

std::vector<Pair> pairs(const std::string &table, const std::string &fast_table)
{
  const std::string clock = " clock 8";  // a power of two: multiplying by it rounds nothing
  return {{"linear rate 0.01 max 0.15" + clock, "linear rate 0.08 max 0.15"},
          {"linear rate -0.01 min 0.09" + clock, "linear rate -0.08 min 0.09"},
          {"polynomial 0.12 0.02 -2e-3 until 4" + clock, "polynomial 0.12 0.16 -128e-3 until 0.5"},
          {"polynomial 1 -0.1 0.01 until 5 gives ratio" + clock, "polynomial 1 -0.8 0.64 until 0.625 gives ratio"},
          {"hydrogel reconstructed millimetre 0.04 second 1e-2" + clock, "hydrogel reconstructed millimetre 0.04 second 0.125e-2"},
          {"tanaka_fillmore final 0.18 tau 3" + clock, "tanaka_fillmore final 0.18 tau 0.375"},
          {"tanaka_fillmore final 0.06 diffusivity 1e-4" + clock, "tanaka_fillmore final 0.06 diffusivity 8e-4"},
          {"table " + table + clock, "table " + fast_table},
          {"linear rate 0.01 max 0.15 scatter 0.3 0.2 seed 4" + clock, "linear rate 0.08 max 0.15 scatter 0.3 0.2 seed 4"}};
}

/// One disc that fits between two walls and is then squeezed by them, across the periodic sides.
std::string squeezed(const std::string &law)
{
  return "fix springs all mass_spring stiffness 400 restitution 0.05\nfix move all nve/cds\nfix flat all enforce2d\n"
         "fix low all wall/gran model hooke/stiffness tangential history primitive type 1 yplane 0.42 absolute_damping on\n"
         "fix high all wall/gran model hooke/stiffness tangential history primitive type 1 yplane 0.58 absolute_damping on\n"
         "fix grow all swell linear " + law + "\ntimestep 1e-3\n";
}

void make_squeezed(DryScene &scene, const std::string &law)
{
  scene.box("0 1 0 1", "p f p", "0.01");
  scene.script("create_objects disk 0.02 0.5 diameter 0.1 points 16 density 1500 cds 0.2\n" + squeezed(law));
}

/// Of the one object, on every rank. Collective.
double pressure(const DryScene &scene)
{
  const LAMMPS_NS::ContactForces contacts(scene.lmp());
  double pressure = 0.0;
  for (const auto &one : scene.objects()->objects())
    if (scene.objects()->owns(one)) pressure = contacts.pressure(one);
  MPI_Allreduce(MPI_IN_PLACE, &pressure, 1, MPI_DOUBLE, MPI_SUM, scene.lmp()->world);
  return pressure;
}

}  // namespace

TEST(DrySwellingClock, IsTheLawWithItsRatesMultiplied)
{
  const TestFile table("clock_table", "time, ratio\n0, 1\n1, 1.2\n3, 1.5\n6, 1.6\n"), fast("clock_table_fast", "time, ratio\n0, 1\n0.125, 1.2\n0.375, 1.5\n0.75, 1.6\n");
  for (const Pair &pair : pairs(table.name, fast.name)) {
    SCOPED_TRACE(pair.by_clock);
    DryScene clock, rates;
    make_four(clock, pair.by_clock);
    make_four(rates, pair.by_rates);
    for (const char *run : {"run 30\n", "run 40\n"}) {
      clock.script(run);
      rates.script(run);
      EXPECT_LT(largest_difference(clock.state(), rates.state()), 1e-12);
      EXPECT_NE(natural_diameter(clock, 1), 0.12);
    }
  }
}

TEST(DrySwellingClock, UnderLoadToo)
{
  DryScene clock, rates;
  make_squeezed(clock, "rate 0.0025 max 0.3 load 10 clock 8");
  make_squeezed(rates, "rate 0.02 max 0.3 load 10");
  for (DryScene *scene : {&clock, &rates}) scene->script("run 2500\n");
  EXPECT_GT(pressure(clock), 1.0) << "the test asks something";
  EXPECT_LT(largest_difference(clock.state(), rates.state()), 1e-11);
  const double clock_time = 8 * 2.5, lost = clock_time - clock.fix("grow")->compute_vector(8);
  EXPECT_NEAR(clock.fix("grow")->compute_vector(7), clock_time, 1e-12);
  EXPECT_GT(lost, 0.0);
  EXPECT_NEAR(lost, 8 * (2.5 - rates.fix("grow")->compute_vector(8)), 1e-9) << "what load takes is the law's time";
}

TEST(DrySwellingClock, GoesOnOverRestartsAndChangesOfStepAndOfItself)
{
  const TestFile file("clock.restart");
  {
    DryScene scene;
    make_four(scene, "linear rate 1e-3 max 0.5 clock 10");
    scene.script("run 50\ntimestep 0.005\nrun 20\n");
    EXPECT_NEAR(scene.fix("grow")->compute_vector(7), 10 * 0.6, 1e-12);
    expect_natural_diameter(scene, 0.12 + 1e-3 * 6, 1e-14);
    scene.script("write_restart " + file.name + "\n");
  }
  for (const double factor : {10.0, 100.0, 0.5}) {
    DryScene scene;
    read_again(scene, file.name, springs_and_motion + std::string("fix grow all swell linear rate 1e-3 max 0.5 clock ") + std::to_string(factor) + "\ntimestep 0.01\nrun 40\n");
    EXPECT_NEAR(scene.fix("grow")->compute_vector(7), 6 + factor * 0.4, 1e-12);
    expect_natural_diameter(scene, 0.12 + 1e-3 * (6 + factor * 0.4), 1e-14);
  }
}

TEST(DrySwellingClock, TheInertialNumberIsTheClosingSpeedAgainstThePressureOfContacts)
{
  for (const std::string load : {"", " load 10"}) {
    DryScene scene;
    make_squeezed(scene, "rate 0.0025 max 0.3 clock 8" + load);
    scene.script("run 300\n");
    LAMMPS_NS::Fix *grow = scene.fix("grow");
    EXPECT_EQ(grow->compute_vector(10), 0.0) << "no contact yet";
    scene.script("run 1700\n");
    const double p = pressure(scene), lambda = swelling_ratio(scene, 1);
    ASSERT_GT(p, 1.0);
    const double rate = load.empty() ? 0.02 : 0.02 * (1 - p / 10);
    const double density = column_of(scene, 1, FixObjects::OBJECT_MASS) / column_of(scene, 1, FixObjects::NATURAL_AREA);
    EXPECT_GT(lambda, 1.1);
    EXPECT_NEAR(grow->compute_vector(10), rate * std::sqrt(density / p), 1e-9);
    EXPECT_EQ(grow->compute_vector(9), 0.0) << "no fluid";
  }
}

TEST(DrySwellingClock, TheMeasureOfAVariableComesFromItsLastStep)
{
  DryScene scene;
  scene.box("0 1 0 1", "p f p", "0.01");
  scene.script("create_objects disk 0.02 0.5 diameter 0.1 points 16 density 1500 cds 0.2\nvariable size equal 0.1+0.02*step*dt\n");
  std::string fixes = squeezed("");
  const std::string none = "linear ";
  scene.script(fixes.replace(fixes.find(none), none.size(), "diameter v_size"));
  scene.script("run 2000\n");
  const double density = column_of(scene, 1, FixObjects::OBJECT_MASS) / column_of(scene, 1, FixObjects::NATURAL_AREA);
  EXPECT_NEAR(scene.fix("grow")->compute_vector(10), 0.02 * std::sqrt(density / pressure(scene)), 1e-9);
}

TEST(DrySwellingClock, NothingThatHasStoppedIsFast)
{
  DryScene scene;
  make_squeezed(scene, "rate 0.0025 max 0.125 clock 8");
  scene.script("run 2000\n");
  EXPECT_GT(pressure(scene), 0.1);
  EXPECT_EQ(scene.fix("grow")->compute_vector(10), 0.0);
}
