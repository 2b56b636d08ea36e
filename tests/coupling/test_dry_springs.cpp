// Springs inside LIGGGHTS: energy, momentum, objects that are spread over ranks, runs in parts.
#include <numbers>

#include "dry_scene.h"

using namespace swellflow_test;

namespace {

constexpr const char *disk = "create_objects disk 0.5 0.5 diameter 0.2 points 20 density 1000 cds 0.1\n";

/// A velocity that stretches, shears and turns the object about (0.5, 0.5).
void set_in_motion(DryScene &scene)
{
  scene.change([](int, double *x, double *v) {
    const double X = x[0] - 0.5, Y = x[1] - 0.5;
    v[0] = 0.8 * X + 0.3 * Y + 0.05, v[1] = -0.5 * Y + 0.9 * X - 0.02;
  });
}

void make(DryScene &scene, const std::string &springs, double step)
{
  scene.box("0 1 0 1");
  scene.script(std::string(disk) + "fix springs all mass_spring " + springs + "\nfix move all nve/cds\n");
  scene.script("timestep " + std::to_string(step) + "\n");
  set_in_motion(scene);
}

double kinetic_energy(const DryScene::State &state)
{
  double energy = 0.0;
  for (const auto &[tag, p] : state) energy += 0.5 * p[5] * (p[2] * p[2] + p[3] * p[3]);
  return energy;
}

std::array<double, 3> momentum(const DryScene::State &state)
{
  std::array<double, 3> sum{};
  for (const auto &[tag, p] : state) {
    sum[0] += p[5] * p[2];
    sum[1] += p[5] * p[3];
    sum[2] += p[5] * ((p[0] - 0.5) * p[3] - (p[1] - 0.5) * p[2]);
  }
  return sum;
}

}  // namespace

TEST(DrySprings, KeepEnergyAndMomentumOverAHundredThousandSteps)
{
  DryScene scene;
  make(scene, "stiffness 1000", 1e-3);
  scene.change([](int, double *, double *v) { v[0] -= 0.05, v[1] += 0.02; });  // stay in the box
  scene.script("run 0\n");
  const auto start = scene.state();
  const double energy = kinetic_energy(start) + scene.fix("springs")->compute_scalar();
  EXPECT_LT(scene.fix("springs")->compute_vector(3), 1.0) << "the step must be a stable one";
  double least = 1e300, most = 0.0;
  for (int part = 0; part < 100; part++) {
    scene.script("run 1000 pre no post no\n");
    const double now = kinetic_energy(scene.state()) + scene.fix("springs")->compute_scalar();
    least = std::min(least, now), most = std::max(most, now);
  }
  EXPECT_GT(least, 0.99 * energy);
  EXPECT_LT(most, 1.01 * energy);
  const auto before = momentum(start), after = momentum(scene.state());
  for (int d = 0; d < 3; d++) EXPECT_NEAR(after[d], before[d], 1e-11);
}

TEST(DrySprings, DashpotsTakeEnergyButNoMomentum)
{
  DryScene scene;
  make(scene, "stiffness 1000 restitution 0.5", 1e-4);
  scene.script("run 0\n");
  const auto start = scene.state();
  double energy = kinetic_energy(start);
  EXPECT_GT(scene.fix("springs")->compute_vector(2), 0.0);
  for (int part = 0; part < 20; part++) {
    scene.script("run 100 pre no post no\n");
    const double now = kinetic_energy(scene.state()) + scene.fix("springs")->compute_scalar();
    EXPECT_LT(now, energy * (1 + 1e-9));
    energy = now;
  }
  const auto before = momentum(start), after = momentum(scene.state());
  for (int d = 0; d < 3; d++) EXPECT_NEAR(after[d], before[d], 1e-12);
}

TEST(DrySprings, SpinDoesNotFeelTheDashpots)
{
  DryScene scene;
  scene.box("0 1 0 1");
  scene.script(std::string(disk) + "fix springs all mass_spring stiffness 1e4 restitution 0.3\nfix move all nve/cds\ntimestep 1e-4\n");
  scene.change([](int, double *x, double *v) { v[0] = -(x[1] - 0.5), v[1] = x[0] - 0.5; });
  const double before = momentum(scene.state())[2];
  scene.script("run 5000\n");
  EXPECT_NEAR(momentum(scene.state())[2], before, 1e-12);
}

TEST(DrySprings, AnyProcessorGridGivesTheSameMotion)
{
  // The object sits on the corner of four ranks, or is cut into strips.
  const auto end_of = [](const std::string &processors, MPI_Comm comm = MPI_COMM_WORLD) {
    DryScene scene(comm);
    scene.script(processors);
    make(scene, "stiffness 1000 restitution 0.7", 5e-4);
    scene.script("run 1000\n");
    return scene.state();
  };
  const auto plain = end_of("");
  EXPECT_LT(largest_difference(plain, end_of("processors 1 * 1\n")), 1e-12);
  EXPECT_LT(largest_difference(plain, end_of("processors * 1 1\n")), 1e-12);
  EXPECT_LT(largest_difference(plain, end_of("", MPI_COMM_SELF)), 1e-12) << "one rank";
}

TEST(DrySprings, TwoRunsAreOne)
{
  const auto end_of = [](const std::string &runs) {
    DryScene scene;
    make(scene, "stiffness 1000 restitution 0.7", 5e-4);
    scene.script(runs);
    return scene.state();
  };
  EXPECT_LT(largest_difference(end_of("run 600\n"), end_of("run 350\nrun 250\n")), 1e-14);
  EXPECT_LT(largest_difference(end_of("run 600\n"), end_of("run 350\nrun 250 pre no\n")), 1e-14);
}

TEST(DrySprings, AGroupMayHoldSomeOfTheObjects)
{
  DryScene scene;
  scene.box("0 1 0 1");
  scene.script("create_objects disk 0.3 0.5 diameter 0.2 points 10 density 1000 cds 0.1\n"
               "create_objects disk 0.7 0.5 diameter 0.2 points 10 density 1000 cds 0.1\n"
               "group left molecule 1\nfix springs left mass_spring stiffness 1000\nfix move all nve/cds\ntimestep 1e-4\n");
  scene.change([](int tag, double *, double *v) { v[0] = tag == 2 || tag == 13 ? 0.1 : 0.0; });
  scene.script("run 10\n");
  const auto state = scene.state();
  EXPECT_LT(state.at(2)[2], 0.1) << "held back by its springs";
  EXPECT_EQ(state.at(13)[2], 0.1) << "free";
}

TEST(DrySprings, NeedNoContactModel)
{
  DryScene scene;
  scene.script("units si\ndimension 2\natom_style hybrid granular molecular\natom_modify map array\nboundary p p p\nnewton off\n"
               "communicate single vel yes\nregion box block 0 1 0 1 -0.005 0.005 units box\ncreate_box 1 box\nneighbor 0.01 bin\n");
  scene.script("create_objects lattice 2 2 origin 0.02 0.2 spacing 0.4 disk diameter 0.1 density 1000\nfix springs all mass_spring stiffness 100\n"
               "fix grow all swell linear rate 0.02 max 0.12\nfix move all nve/cds\ntimestep 1e-3\n");
  scene.change([](int, double *, double *v) { v[0] = -1.0; });
  scene.script("run 1000\nrun 1000\n");
  EXPECT_EQ(scene.state().size(), 84u);
  EXPECT_NEAR(scene.state().at(1)[0], 0.02 - 2.0, 1e-9);
  EXPECT_NEAR(scene.fix("grow")->compute_vector(1), 0.12, 5e-3) << "it swings, undamped";
}
