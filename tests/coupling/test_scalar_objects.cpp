// A scalar in a fluid with objects: what they feel of it, take up of it, and how they swell by it.
#include "coupled_scene.h"
#include "fix_property_atom.h"
#include "liggghts_plugins/fix_fluid_ib.h"
#include "liggghts_plugins/fix_fluid_scalar.h"
#include "swelling_scene.h"

using namespace swellflow_test;

namespace {

constexpr double round_off = 1e-13;

/// Twelve discs that the flow drives down a column that is periodic in y, and that swell while they go. With a name for each of the lines that tests change.
struct Column {
  std::string processors = "* * 1", scalar = "diffusivity 1e-3 feed yhi 1", swell = "linear rate 0.1 max 0.26 fed_by fresh", integrator = "nve/cds implicit",
              fluid = "pressure_drop 0 -2000", boundary = "f p p";

  void make(CoupledScene &scene) const
  {
    scene.script("processors " + processors + "\n");
    scene.box("0 1 0 2", boundary);
    scene.script("create_objects lattice 3 4 origin 0.2 0.45 spacing 0.3 disk diameter 0.2 points 16 density 1000 cds 0.2\n");
    if (integrator != "rigid/cds") scene.script("fix springs all mass_spring stiffness 1000 restitution 0.5\n");
    scene.script("fix move all " + integrator + "\nfix grow all swell " + swell + "\n");
    scene.script("fix water all fluid/ib cells 24 48 density 1000 viscosity 0.05 every 2 " + fluid + "\n");
    if (!scalar.empty()) scene.script("fix fresh all fluid/scalar " + scalar + "\n");
    scene.script("timestep 2.5e-3\n");
  }
};

double fresh(const CoupledScene &scene, int n) { return scene.fix("fresh")->compute_vector(n - 1); }

/// The scalar in all cells, on every rank.
std::vector<double> field(const CoupledScene &scene)
{
  const auto &fluid = *dynamic_cast<LAMMPS_NS::FixFluidIb &>(*scene.fix("water")).partner();
  const swellflow::FieldBlock block = fluid.field_block();
  std::vector<double> own, all(block.global_cells[0] * block.global_cells[1], 0.0);
  fluid.copy_field("fresh", own);
  std::copy(own.begin(), own.end(), all.begin() + block.global_cells[0] * block.first[1]);
  MPI_Allreduce(MPI_IN_PLACE, all.data(), all.size(), MPI_DOUBLE, MPI_SUM, scene.lmp()->world);
  return all;
}

/// Of what objects have taken up, by their own account; and the growth of their natural area.
struct Objects {
  explicit Objects(const CoupledScene &scene)
  {
    const auto &scalar = dynamic_cast<LAMMPS_NS::FixFluidScalar &>(*scene.fix("fresh"));
    double sums[2] = {};
    for (const auto &object : scene.objects()->objects()) {
      if (!scene.objects()->owns(object)) continue;
      const int hub = scene.objects()->own_index(object.hub);
      const double *point = scene.objects()->points()[hub], lambda = scene.objects()->sizes()[hub][FixObjects::LAMBDA];
      sums[0] += scalar.uptake(hub);
      sums[1] += (lambda * lambda - 1.0) * point[FixObjects::NATURAL_AREA];
    }
    MPI_Allreduce(MPI_IN_PLACE, sums, 2, MPI_DOUBLE, MPI_SUM, scene.lmp()->world);
    uptake = sums[0];
    growth = sums[1];
  }
  double uptake, growth;
};

double smallest_diameter(const CoupledScene &scene)
{
  double smallest = HUGE_VAL;
  for (int object = 1; object <= 12; object++) smallest = std::min(smallest, natural_diameter(scene, object));
  return smallest;
}

// ---- ranks -----------------------------------------------------------------------------------------------------------------------------------

/// Objects lie on several ranks, cross their borders and the periodic side while they swell and drink.
TEST(ScalarObjects, AreTheSameOnAnyRanks)
{
  for (const std::string processors : {"* * 1", "1 * 1"}) {
    CoupledScene scene, alone(MPI_COMM_SELF);
    Column column;
    column.processors = processors;
    column.make(scene);
    column.processors = "* * 1";
    column.make(alone);
    for (CoupledScene *each : {&scene, &alone}) each->script("run 600\n");
    EXPECT_GT(fresh(alone, 7), 0.01);
    EXPECT_GT(fresh(alone, 6), 0.0);
    EXPECT_LT(largest_difference(scene.state(), alone.state()), 1e-10);
    const std::vector<double> a = field(scene), b = field(alone);
    for (std::size_t i = 0; i < a.size(); i++) EXPECT_NEAR(a[i], b[i], 1e-10);
    for (const int n : {1, 2, 3, 4, 5, 6, 7, 9, 10, 11, 12}) EXPECT_NEAR(fresh(scene, n), fresh(alone, n), 1e-10) << n;
    EXPECT_LT(fresh(scene, 8), round_off);
  }
}

// ---- swelling --------------------------------------------------------------------------------------------------------------------------------

TEST(FedSwelling, StandsStillWithoutFood)
{
  for (const std::string law : {"linear rate 0.1 max 0.26", "tanaka_fillmore final 0.26 tau 1"}) {
    CoupledScene scene;
    Column{.scalar = "diffusivity 1e-3", .swell = law + " fed_by fresh"}.make(scene);
    scene.script("run 100\n");
    for (int object = 1; object <= 12; object++) EXPECT_EQ(natural_diameter(scene, object), 0.2);
    EXPECT_EQ(fresh(scene, 1), 0.0);
  }
}

TEST(FedSwelling, IsTheLawWhereFoodIsPlenty)
{
  for (const std::string law : {"linear rate 0.1 max 0.26", "tanaka_fillmore final 0.26 tau 1", "linear rate 0.1 max 0.26 load 1e3"}) {
    CoupledScene fed, plain;
    Column{.scalar = "diffusivity 1e-3 initial 1 uptake 0", .swell = law + " fed_by fresh"}.make(fed);
    Column{.scalar = "", .swell = law}.make(plain);
    for (CoupledScene *each : {&fed, &plain}) each->script("run 101\n");
    EXPECT_GT(smallest_diameter(plain), 0.21);
    EXPECT_LT(largest_difference(fed.state(), plain.state()), 1e-12);
  }
}

/// Half of what is full: half the speed. Twice of it: no more than the law.
TEST(FedSwelling, GoesWithTheShareOfFull)
{
  for (const auto &[initial, full, speed] : {std::tuple{"0.25", "0.5", 0.5}, std::tuple{"1", "0.5", 1.0}}) {
    CoupledScene scene;
    Column{.scalar = std::string("diffusivity 0 uptake 0 initial ") + initial, .swell = std::string("linear rate 0.1 max 0.26 fed_by fresh full ") + full}.make(scene);
    scene.script("run 60\nrun 40\n");
    for (int object = 1; object <= 12; object++) EXPECT_NEAR(natural_diameter(scene, object), 0.2 + 0.1 * speed * 100 * 2.5e-3, 1e-12);
  }
}

// ---- uptake ----------------------------------------------------------------------------------------------------------------------------------

/// Rigid objects have, at the end of their law, the area that it gives: what they took, and what they are still owed, is U times its growth.
TEST(Uptake, IsTheGrowthOfArea)
{
  for (const double U : {1.0, 0.25}) {
    CoupledScene scene;
    Column{.scalar = "diffusivity 1e-3 initial 0.5 feed yhi 1 uptake " + std::to_string(U), .swell = "linear rate 0.1 max 0.24 fed_by fresh full 0.1", .integrator = "rigid/cds"}.make(scene);
    scene.script("run 300\nrun 50\n");
    const Objects objects(scene);
    EXPECT_GT(objects.growth, 0.05);
    EXPECT_NEAR(objects.uptake + fresh(scene, 10), U * objects.growth, 1e-12);
    EXPECT_LT(std::abs(fresh(scene, 10)), 1e-3 * objects.uptake);
    EXPECT_NEAR(objects.uptake, fresh(scene, 7), 1e-13);
    EXPECT_NEAR(fresh(scene, 1), 1.0 + fresh(scene, 5) - fresh(scene, 6) - fresh(scene, 7), 1e-12);
    EXPECT_LT(fresh(scene, 8), round_off);
  }
}

/// Objects that grow where there is next to nothing take what there is, and are owed the rest: nothing falls below zero.
TEST(Uptake, TakesNoMoreThanThereIs)
{
  CoupledScene scene;
  Column{.scalar = "diffusivity 0 initial 0.02", .swell = "linear rate 0.1 max 0.26", .integrator = "rigid/cds", .fluid = ""}.make(scene);
  scene.script("run 300\n");
  const Objects objects(scene);
  EXPECT_GE(fresh(scene, 3), 0.0);
  EXPECT_GT(objects.uptake, 0.0);
  EXPECT_GT(fresh(scene, 10), 10.0 * objects.uptake);
  EXPECT_NEAR(objects.uptake + fresh(scene, 10), objects.growth, 1e-12);
  EXPECT_LT(fresh(scene, 8), round_off);
}

// ---- the flow --------------------------------------------------------------------------------------------------------------------------------

/// A scalar that nobody feeds on leaves the run as it is, to the last bit; also when it is taken away and made anew.
TEST(ScalarObjects, LeaveTheFlowAsItIs)
{
  CoupledScene with, without;
  Column{.swell = "linear rate 0.1 max 0.26"}.make(with);
  Column{.scalar = "", .swell = "linear rate 0.1 max 0.26"}.make(without);
  for (CoupledScene *each : {&with, &without}) each->script("run 50\n");
  EXPECT_EQ(largest_difference(with.state(), without.state()), 0.0);
  EXPECT_GT(fresh(with, 1), 0.0);
  with.script("unfix fresh\n");
  for (CoupledScene *each : {&with, &without}) each->script("run 10\n");
  with.script("fix fresh all fluid/scalar diffusivity 0 initial 0.5\n");
  for (CoupledScene *each : {&with, &without}) each->script("run 10\n");
  EXPECT_EQ(largest_difference(with.state(), without.state()), 0.0);
  EXPECT_NEAR(fresh(with, 2) + fresh(with, 7) / 2.0, 0.5, 1e-13);
}

/// What appears inside objects that push the water away has the value of its place, so that what is uniform stays so.
TEST(ScalarObjects, StayUniformWhereObjectsInflate)
{
  CoupledScene scene;
  Column{.scalar = "diffusivity 1e-3 initial 0.75 uptake 0", .swell = "linear rate 0.1 max 0.26 absorb no fed_by fresh full 0.5", .fluid = "outflow ylo", .boundary = "f f p"}.make(scene);
  scene.script("run 100\n");
  EXPECT_GT(fresh(scene, 11), 0.02);
  EXPECT_NEAR(fresh(scene, 3), 0.75, 1e-11);
  EXPECT_NEAR(fresh(scene, 4), 0.75, 1e-11);
  EXPECT_LT(fresh(scene, 8), round_off);
}

/// In a region at the start, through an inflow by a variable, on a wall.
TEST(ScalarObjects, FollowTheScript)
{
  CoupledScene scene;
  scene.script("units si\ndimension 2\natom_style granular\natom_modify map array\nboundary f f p\nnewton off\ncommunicate single vel yes\n"
               "region box block 0 1 0 1 -0.005 0.005 units box\ncreate_box 1 box\nneighbor 0.01 bin\nvariable pulse equal 2*(time<0.1)\n");
  scene.script("region left block 0 0.25 INF INF INF INF units box\n"
               "fix water all fluid/ib cells 16 16 density 1000 viscosity 0.05 inflow ylo uniform 0 0.5 outflow yhi slip xlo slip xhi initial_velocity 0 0.5\n"
               "fix fresh all fluid/scalar diffusivity 0 initial 0.5 region left 1 feed ylo v_pulse\n"
               "fix warm all fluid/scalar diffusivity 1 feed ylo 0 value xhi 3\ntimestep 1e-2\nrun 0\n");
  EXPECT_NEAR(fresh(scene, 1), 0.25 + 0.75 * 0.5, round_off);
  scene.script("run 20\n");
  // For nine steps there was time < 0.1 at their end: 2 x 0.5 x 0.09. As much water has left as came, of 1 and 0.5.
  EXPECT_NEAR(fresh(scene, 5), 0.09, round_off);
  EXPECT_NEAR(fresh(scene, 6), 0.5 * 0.2 * 0.625, round_off);
  EXPECT_LT(fresh(scene, 8), round_off);
  EXPECT_GT(scene.fix("warm")->compute_vector(3), 0.5);
  EXPECT_LT(scene.fix("warm")->compute_vector(7), round_off);
}

}  // namespace
