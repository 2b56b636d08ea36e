// How far and how fast objects turn, over runs and restart files, and what energy they have; on any number of ranks.
#include <cstdio>
#include <numbers>

#include "measured_objects.h"

using namespace swellflow_test;
using swellflow::ObjectMeasures;

namespace {

constexpr double pi = std::numbers::pi;

/// One on the border of all ranks, one across the corners of a periodic box, both turning; a third whose points have other masses and places.
void make_turning_scene(DryScene &scene, const std::string &spin)
{
  scene.box("0 1 0 1", "p p p");
  scene.script("create_objects disk 0.5 0.5 diameter 0.2 points 10 density 1000 cds 0.1\ncreate_objects disk 0.97 0.96 diameter 0.2 points 10 density 1000 cds 0.1\n"
               "create_objects disk 0.25 0.6 diameter 0.1 points 3 density 1000 cds 0.1\nfix move all prescribed velocity 0.05 0.1 spin " + spin +
               "\ntimestep 1e-3\n");
}

}  // namespace

TEST(DryTurns, TurnsOfASpinningObjectAreCounted)
{
  for (const double spin : {3.0, -3.0}) {
    DryScene scene;
    make_turning_scene(scene, std::to_string(spin));
    scene.script("run 5000\n");  // more than two turns, which nobody measures meanwhile
    const Measures measures = measures_of(scene);
    ASSERT_EQ(measures.size(), 3u);
    for (const auto &[id, object] : measures) {
      EXPECT_NEAR(object.rotation, 5.0 * spin, 1e-9);
      EXPECT_NEAR(object.spin, spin, 1e-11);
      EXPECT_NEAR(object.velocity[0], 0.05, 1e-12);
      EXPECT_NEAR(object.velocity[1], 0.1, 1e-12);
      EXPECT_NEAR(object.aspect_ratio, 1.0, 1e-9);
    }
  }
}

TEST(DryTurns, TurnsAreCountedOnFromARestartFile)
{
  const std::string file = "turning_" + std::to_string(ranks()) + ".restart";
  {
    DryScene scene;
    make_turning_scene(scene, "4");
    scene.script("run 2500\nwrite_restart " + file + "\n");
  }
  DryScene scene;
  scene.script("atom_modify map array\nread_restart " + file + "\nnewton off\ncommunicate single vel yes\nsoft_particles yes\n");
  scene.settings();
  scene.script("fix move all prescribed velocity 0.05 0.1 spin 4\ntimestep 1e-3\nrun 2500\n");
  for (const auto &[id, object] : measures_of(scene)) EXPECT_NEAR(object.rotation, 20.0, 1e-9);
  MPI_Barrier(MPI_COMM_WORLD);
  if (rank() == 0) std::remove(file.c_str());
}

TEST(DryTurns, EnergyAndSpinOfAFreeObject)
{
  DryScene scene;
  scene.box("0 1 0 1");
  scene.script("create_objects disk 0.5 0.5 diameter 0.4 points 12 density 1000 cds 0.1\nfix springs all mass_spring stiffness 1000\nrun 0\n");
  scene.change([](int, double *x, double *v) {
    v[0] = 0.3 - 2.0 * (x[1] - 0.5), v[1] = 2.0 * (x[0] - 0.5);
    x[0] = 0.5 + 1.1 * (x[0] - 0.5), x[1] = 0.5 + 1.1 * (x[1] - 0.5);
  });
  scene.script("run 0\n");
  const ObjectMeasures disc = measures_of(scene).at(1);
  double kinetic = 0.0;
  for (const auto &[tag, p] : scene.state()) kinetic += 0.5 * p[5] * (p[2] * p[2] + p[3] * p[3]);
  EXPECT_NEAR(disc.kinetic_energy, kinetic, 1e-12 * kinetic);
  EXPECT_NEAR(disc.velocity[0], 0.3, 1e-12);
  EXPECT_NEAR(disc.spin, 2.0 / 1.1, 1e-12);
  const double spoke = 0.02, chord = 0.04 * std::sin(pi / 12.0);
  EXPECT_NEAR(disc.spring_energy, 0.5 * 1000.0 * 12 * (spoke * spoke + chord * chord), 1e-10);
  EXPECT_NEAR(disc.spring_energy, scene.fix("springs")->compute_scalar(), 1e-12);
  EXPECT_NEAR(disc.mean_diameter, 0.44, 1e-12);
  EXPECT_NEAR(disc.diameter_of_area, 0.44, 1e-12);
  EXPECT_NEAR(disc.area_ratio, 1.21, 1e-12);
  EXPECT_NEAR(disc.mass, 1000.0 * pi * 0.04, 1e-9);
  EXPECT_NEAR(disc.rotation, 0.0, 1e-14);
}
