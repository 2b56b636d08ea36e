// A restart file continues the run as if it had not been interrupted, on as many ranks or on others.
#include <cstdio>

#include "dry_scene.h"

using namespace swellflow_test;
using LAMMPS_NS::FixObjects;

namespace {

constexpr const char *fixes =
    "fix springs all mass_spring stiffness 1000 restitution 0.8\nfix grow all swell linear rate 0.05 max 0.2\n"
    "fix move all nve/cds\nfix flat all enforce2d\n"
    "fix bottom all wall/gran model hooke/stiffness tangential history primitive type 1 yplane 0.0 absolute_damping on\n"
    "timestep 1e-3\n";

void begin(DryScene &scene)
{
  scene.box("0 1 0 1");
  scene.script("create_objects lattice 3 3 origin 0.2 0.2 spacing 0.28 disk diameter 0.16 points 20 density 1500 cds 0.2\n");
  scene.script(fixes);
  scene.change([](int tag, double *, double *v) { v[0] = 0.2 * std::sin(1.0 * tag), v[1] = 0.2 * std::cos(2.0 * tag); });
}

DryScene::State uninterrupted()
{
  DryScene scene;
  begin(scene);
  scene.script("run 600\n");
  return scene.state();
}

void write_half(MPI_Comm comm, const std::string &file)
{
  DryScene scene(comm);
  begin(scene);
  scene.script("run 300\nwrite_restart " + file + "\n");
}

DryScene::State read_half(MPI_Comm comm, const std::string &file)
{
  DryScene scene(comm);
  scene.script("atom_modify map array\nread_restart " + file + "\nnewton off\ncommunicate single vel yes\nsoft_particles yes\n");
  scene.settings();
  scene.script(fixes);
  scene.script("run 300\n");
  EXPECT_NEAR(scene.fix("grow")->compute_scalar(), 0.16 + 0.05 * 0.6, 1e-14);
  return scene.state();
}

/// All ranks write together, each rank alone reads the same file, and so on.
double difference_after(bool together, bool read_together)
{
  const std::string file = "half_" + std::to_string(ranks()) + (together ? "_many" : "_one") + (read_together ? "_many" : "_one") + ".restart";
  if (together || rank() == 0) write_half(together ? MPI_COMM_WORLD : MPI_COMM_SELF, file);
  MPI_Barrier(MPI_COMM_WORLD);
  const auto state = read_half(read_together ? MPI_COMM_WORLD : MPI_COMM_SELF, file);
  MPI_Barrier(MPI_COMM_WORLD);
  if (rank() == 0) std::remove(file.c_str());
  const double difference = largest_difference(state, uninterrupted());
  if (rank() == 0) std::printf("restart on %s from %s: largest difference %.2g\n", read_together ? "all" : "one", together ? "all" : "one", difference);
  return difference;
}

}  // namespace

TEST(DryRestart, AllToAll) { EXPECT_LT(difference_after(true, true), 1e-12); }
TEST(DryRestart, AllToOne) { EXPECT_LT(difference_after(true, false), 1e-12); }
TEST(DryRestart, OneToAll) { EXPECT_LT(difference_after(false, true), 1e-12); }

TEST(DryRestart, RunsInPartsAndLoopsAreOneRun)
{
  const auto whole = uninterrupted();
  {
    DryScene scene;
    begin(scene);
    scene.script("run 300\nrun 300\n");
    EXPECT_LT(largest_difference(scene.state(), whole), 1e-12);
  }
  DryScene scene;
  begin(scene);
  for (int loop = 0; loop < 6; loop++) scene.script("run 100\n");
  EXPECT_LT(largest_difference(scene.state(), whole), 1e-12);
}

TEST(DryRestart, AFileWrittenDuringTheRunChangesNothing)
{
  DryScene scene;
  begin(scene);
  const std::string file = "during_" + std::to_string(ranks()) + ".restart";
  scene.script("restart 150 " + file + " " + file + "\nrun 600\n");
  EXPECT_LT(largest_difference(scene.state(), uninterrupted()), 1e-12);
  MPI_Barrier(MPI_COMM_WORLD);
  if (rank() == 0) std::remove(file.c_str());
}
