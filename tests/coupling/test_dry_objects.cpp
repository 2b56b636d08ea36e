// Making objects: what LIGGGHTS then holds, on any number of ranks, in open and periodic boxes.
#include <ctime>
#include <fstream>
#include <numbers>
#include <set>

#include "dry_scene.h"
#include "liggghts_plugins/sort_bins.h"

using namespace swellflow_test;
using LAMMPS_NS::FixObjects;
using std::numbers::pi;

namespace {

double sum_over_ranks(double value)
{
  MPI_Allreduce(MPI_IN_PLACE, &value, 1, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
  return value;
}

/// How often the next atom in memory is one of another object, over the number of objects on this rank.
double breaks_per_object(const LAMMPS_NS::Atom &atom)
{
  int breaks = 0;
  std::set<int> objects;
  for (int i = 0; i < atom.nlocal; i++) {
    breaks += i > 0 && atom.molecule[i] != atom.molecule[i - 1];
    objects.insert(atom.molecule[i]);
  }
  return breaks / std::max<double>(1.0, objects.size());
}

}  // namespace

TEST(CreateObjects, PointsOfAnObjectStayTogetherInMemory)
{
  const std::string bed = "create_objects lattice 20 20 origin 0.05 0.05 spacing 0.1 disk diameter 0.095 points 20 density 1000 cds 0.1\nfix move all nve/cds\nrun 1\n";
  DryScene scene;
  scene.box("0 2 0 2", "p p p", "0.01", "-0.05 0.05");
  scene.script(bed);
  EXPECT_DOUBLE_EQ(LAMMPS_NS::sort_bin_size(*scene.atom()), 8 * 0.095);
  EXPECT_LT(breaks_per_object(*scene.atom()), 2.0);
  DryScene by_script;  // whose bins are those that the script names
  by_script.box("0 2 0 2", "p p p", "0.01", "-0.05 0.05");
  by_script.script("atom_modify sort 1000 0.02\n" + bed);
  EXPECT_DOUBLE_EQ(LAMMPS_NS::sort_bin_size(*by_script.atom()), 0.02);
  EXPECT_GT(breaks_per_object(*by_script.atom()), 4.0);
}

TEST(CreateObjects, LatticeHoldsTheDisksMassRadiiAndIds)
{
  DryScene scene;
  scene.box("0 1 0 1");
  scene.script("create_objects lattice 4 4 origin 0.164 0.164 spacing 0.224 disk diameter 0.12 points 20 density 1500 cds 0.2 type 1\n");
  EXPECT_EQ(scene.atom()->natoms, 16 * 21);
  const auto state = scene.state();
  double mass = 0.0;
  for (const auto &[tag, values] : state) mass += values[5];
  EXPECT_NEAR(mass, 16 * 1500 * pi * 0.12 * 0.12 / 4, 1e-9);
  const double disk_mass = 1500 * pi * 0.12 * 0.12 / 4;
  EXPECT_NEAR(state.at(1)[5], disk_mass / 2, 1e-12);
  EXPECT_NEAR(state.at(2)[5], disk_mass / 40, 1e-12);
  EXPECT_NEAR(state.at(2)[4], 0.024, 1e-15);
  EXPECT_NEAR(state.at(2)[0], 0.164 + 0.06, 1e-15);
  EXPECT_NEAR(state.at(1 + 15 * 21)[1], 0.164 + 3 * 0.224, 1e-15);
  for (int i = 0; i < scene.atom()->nlocal; i++) {
    EXPECT_EQ(scene.atom()->molecule[i], (scene.atom()->tag[i] - 1) / 21 + 1);
    const double r = scene.atom()->radius[i];
    EXPECT_NEAR(scene.atom()->density[i] * pi * r * r, scene.atom()->rmass[i], 1e-12);
  }
}

TEST(CreateObjects, EqualMassIsThePapers)
{
  DryScene scene;
  scene.box("0 1 0 1");
  scene.script("create_objects disk 0.5 0.5 diameter 0.2 points 20 density 1500 mass equal\n");
  for (const auto &[tag, values] : scene.state()) EXPECT_NEAR(values[5], 1500 * pi * 0.01 / 21, 1e-12);
}

TEST(CreateObjects, FileGivesEachObjectItsOwnSize)
{
  const std::string name = "objects_" + std::to_string(ranks()) + ".csv";
  if (rank() == 0) std::ofstream(name) << "# two of them\nx, y, diameter, points\n0.3,0.3,0.1,12\n\n0.7,0.7,0.2,16\n";
  MPI_Barrier(MPI_COMM_WORLD);
  DryScene scene;
  scene.box("0 1 0 1");
  scene.script("create_objects file " + name + " density 1000 cds 0.1\n");
  const auto state = scene.state();
  EXPECT_EQ(state.size(), 13u + 17u);
  EXPECT_NEAR(state.at(14)[0], 0.7, 1e-15);
  EXPECT_NEAR(state.at(15)[0], 0.8, 1e-15);
  EXPECT_NEAR(state.at(15)[4], 0.02, 1e-15);
  MPI_Barrier(MPI_COMM_WORLD);
  if (rank() == 0) std::remove(name.c_str());
}

TEST(CreateObjects, LaterObjectsContinueTagsAndIds)
{
  DryScene scene;
  scene.box("0 1 0 1");
  scene.script("create_objects disk 0.3 0.3 diameter 0.1 points 10 density 1000\n"
               "fix springs all mass_spring stiffness 1000\nfix move all nve/cds\ntimestep 1e-4\nrun 5\n"
               "create_objects disk 0.7 0.7 diameter 0.1 points 10 density 1000\nrun 5\n");
  const auto state = scene.state();
  ASSERT_EQ(state.size(), 22u);
  EXPECT_NEAR(state.at(12)[0], 0.7, 1e-12);
  int molecules = 0;
  for (int i = 0; i < scene.atom()->nlocal; i++) molecules = std::max(molecules, scene.atom()->molecule[i]);
  MPI_Allreduce(MPI_IN_PLACE, &molecules, 1, MPI_INT, MPI_MAX, MPI_COMM_WORLD);
  EXPECT_EQ(molecules, 2);
}

TEST(CreateObjects, WrapsAtPeriodicSidesAndKeepsItsShape)
{
  DryScene scene;
  scene.box("0 1 0 1", "p p p");
  scene.script("create_objects disk 0.02 0.97 diameter 0.2 points 20 density 1000 cds 0.1\n"
               "fix springs all mass_spring stiffness 1000\nfix move all nve/cds\ntimestep 1e-4\n");
  scene.change([](int, double *, double *v) { v[0] = 1.0, v[1] = -0.5; });
  scene.script("thermo_modify lost error\nrun 3000\n");
  const auto state = scene.state();
  ASSERT_EQ(state.size(), 21u);
  for (int k = 0; k < 20; k++) {
    EXPECT_NEAR(state.at(2 + k)[0] - state.at(1)[0], 0.1 * std::cos(2 * pi * k / 20), 1e-9);
    EXPECT_NEAR(state.at(2 + k)[1] - state.at(1)[1], 0.1 * std::sin(2 * pi * k / 20), 1e-9);
  }
  EXPECT_NEAR(state.at(1)[0], 0.02 + 0.3, 1e-9);
}

TEST(CreateObjects, EveryRankSeesWholeObjects)
{
  DryScene scene;
  scene.box("0 1 0 1");
  scene.script("create_objects lattice 3 3 origin 0.2 0.2 spacing 0.3 disk diameter 0.25 points 20 density 1000 cds 0.05\n"
               "fix springs all mass_spring stiffness 1000\nfix move all nve/cds\ntimestep 1e-4\nrun 0\n");
  double owned = 0.0;
  for (const auto &object : scene.objects()->objects()) {
    owned += scene.objects()->owns(object);
    for (int k = 0; k < object.n_ring; k++) {
      const double *hub = scene.atom()->x[object.hub], *x = scene.atom()->x[object.ring[k]];
      EXPECT_NEAR(x[0] - hub[0], 0.125 * std::cos(2 * pi * k / 20), 1e-12);
      EXPECT_NEAR(x[1] - hub[1], 0.125 * std::sin(2 * pi * k / 20), 1e-12);
    }
  }
  EXPECT_EQ(sum_over_ranks(owned), 9);
}

TEST(CreateObjects, TenThousandInUnderASecond)
{
  DryScene scene;
  scene.box("0 100 0 100", "f f p", "0.1");
  // Processor time of one rank: the machine may be busy with other things, and ranks may outnumber its cores.
  const std::clock_t start = std::clock();
  scene.script("create_objects lattice 100 100 origin 0.5 0.5 spacing 0.99 disk diameter 0.6 points 20 density 1500\n");
  const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  if (rank() == 0) std::printf("10,000 objects of 21 points made in %.3f s on %d ranks\n", seconds, ranks());
  EXPECT_EQ(scene.atom()->natoms, 210000);
#ifndef __SANITIZE_ADDRESS__
  if (ranks() == 1) {
    EXPECT_LT(seconds, 1.0);
  }
#endif
}

TEST(CreateObjects, ClearAndUnfixLeaveNothingBehind)
{
  DryScene scene;
  for (int round = 0; round < 3; round++) {
    scene.script("clear\n");
    scene.box("0 1 0 1");
    scene.script("create_objects disk 0.5 0.5 diameter 0.2 points 10 density 1000\n"
                 "fix springs all mass_spring stiffness 1000\nfix move all nve/cds\ntimestep 1e-4\nrun 10\nunfix springs\nrun 10\n"
                 "fix springs all mass_spring stiffness 1000\nrun 10\n");
    EXPECT_EQ(scene.state().size(), 11u);
  }
}
