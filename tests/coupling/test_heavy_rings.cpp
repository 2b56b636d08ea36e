// Rings that are too heavy for the forcing of outlines to stop them, and contacts that do not last.
#include "coupled_scene.h"
#include "liggghts_plugins/object_geometry.h"
#include "liggghts_plugins/objects/outline.h"

using namespace swellflow_test;

namespace {

constexpr double fluid_step = 0.025;

/// Two soft discs, a thousand times as heavy as the fluid, that run into each other.
class Collision : public CoupledScene {
public:
  Collision(const std::string &integrator, int every, MPI_Comm comm = MPI_COMM_WORLD) : CoupledScene(comm), every_(every)
  {
    box("0 3 0 6", "p p p", "0.05");
    script("create_objects disk 1.52 2.425 diameter 1 points 40 density 1000 cds 0.1 reach 0\ncreate_objects disk 1.48 3.575 diameter 1 points 40 density 1000 cds 0.1 reach 0\n");
    script("group lower molecule 1\ngroup upper molecule 2\nvelocity lower set 0 0.5 0 units box\nvelocity upper set 0 -0.5 0 units box\n");
    script("fix springs all mass_spring stiffness 1000\nfix move all " + integrator + "\nfix flat all enforce2d\n");
    script("fix water all fluid/ib cells 36 72 density 1 viscosity 0.05 every " + std::to_string(every) + "\ntimestep " + std::to_string(fluid_step / every) + "\n");
  }
  void fluid_steps(int n) { script("run " + std::to_string(n * every_) + "\n"); }
  /// Of either, over that of a disc that is as it was made.
  double smallest_area() const
  {
    double smallest = HUGE_VAL;
    for (const swellflow::ObjectPoints &object : objects()->objects())
      if (objects()->owns(object)) smallest = std::min(smallest, swellflow::polygon_area(LAMMPS_NS::outline_of(lmp(), object)).area);
    MPI_Allreduce(MPI_IN_PLACE, &smallest, 1, MPI_DOUBLE, MPI_MIN, lmp()->world);
    return smallest / swellflow::regular_polygon_area(40, 1.0);
  }

private:
  int every_;
};

class HeavyRings : public testing::TestWithParam<std::pair<const char *, int>> {};

// The fluid inside cannot be pressed. Stopped by the forcing alone they lose a seventh.
TEST_P(HeavyRings, KeepTheirAreaWhenTheyCollide)
{
  Collision scene(GetParam().first, GetParam().second);
  double smallest = 1.0, momentum = 0.0;
  for (int k = 0; k < 10; k++) {
    scene.fluid_steps(10);
    smallest = std::min(smallest, scene.smallest_area());
    momentum = std::max(momentum, scene.water(8));
  }
  EXPECT_GT(smallest, 0.97);
  EXPECT_LT(momentum, 1e-11) << "a pressure within a closed line has no sum";
}

TEST_P(HeavyRings, MoveTheSameOnManyRanks)
{
  Collision parallel(GetParam().first, GetParam().second), alone(GetParam().first, GetParam().second, MPI_COMM_SELF);
  for (Collision *scene : {&parallel, &alone}) scene->fluid_steps(40);
  EXPECT_LT(largest_difference(parallel.state(), alone.state()), 1e-9);
}

INSTANTIATE_TEST_SUITE_P(Integrators, HeavyRings, testing::Values(std::pair("nve/cds", 5), std::pair("nve/cds", 12), std::pair("nve/cds implicit", 5), std::pair("nve/cds implicit", 1)));

// A disc falls to the floor in fluid steps that are longer than its contact. Foreseen as if it lasted, the contact keeps it bouncing for ever: 1 by then, and more later.
TEST(Contacts, ThatBounceComeToRest)
{
  CoupledScene scene;
  scene.box("0 2.583333333333 0 5.166666666667", "f f p", "0.05");
  scene.script("create_objects disk 1.291666666667 1.2 diameter 1.3 points 40 density 1.5 cds 0.1 reach 0\nfix move all rigid/cds\nfix flat all enforce2d\n");
  scene.script("fix weight all gravity 9.156 vector 0 -1 0\nfix floor all wall/gran model hooke/stiffness tangential history primitive type 1 yplane 0 absolute_damping on\n");
  scene.script("fix water all fluid/ib cells 31 62 density 1 viscosity 0.05 every 58\ntimestep 0.00143678\nrun 2900\n");
  double fastest = 0.0;
  for (int k = 0; k < 150; k++) {
    scene.script("run 58\n");
    fastest = std::max(fastest, scene.fastest_point());
  }
  EXPECT_LT(fastest, 0.1);
}

}  // namespace
