// Objects of any shape in LIGGGHTS: what the points are, hubs that follow, spheres that are left out, on any number of ranks and over restarts.
#include <ctime>
#include <fstream>
#include <numbers>

#include "dry_scene.h"
#include "neigh_list.h"
#include "neighbor.h"
#include "pair.h"
#include "force.h"

using namespace swellflow_test;
using LAMMPS_NS::FixObjects;
using std::numbers::pi;

namespace {

constexpr const char *walls =
    "fix bottom all wall/gran model hooke/stiffness tangential history primitive type 1 yplane 0.0 absolute_damping on\n"
    "fix left all wall/gran model hooke/stiffness tangential history primitive type 1 xplane 0.0 absolute_damping on\n"
    "fix right all wall/gran model hooke/stiffness tangential history primitive type 1 xplane 1.0 absolute_damping on\n"
    "fix top all wall/gran model hooke/stiffness tangential history primitive type 1 yplane 1.0 absolute_damping on\n";

constexpr const char *motion =
    "fix springs all mass_spring stiffness 3000 restitution 0.9\nfix move all nve/cds\nfix flat all enforce2d\nfix weight all gravity 2 vector 0 -1 0\n"
    "timestep 2e-4\n";

/// One of everything, thrown about so that they meet.
void mixed_bed(DryScene &scene)
{
  scene.box("0 1 0 1");
  scene.script("create_objects ellipse 0.25 0.2 axes 0.3 0.15 angle 30 points 24 density 30 cds 0.08\n"
               "create_objects disk 0.7 0.25 diameter 0.25 points 24 density 30 cds 0.08 spokes no\n"
               "create_objects disk 0.25 0.55 diameter 0.2 density 30 cds 0.1 reach 0.02\n"
               "create_objects lattice 3 1 origin 0.55 0.6 spacing 0.14 ellipse axes 0.12 0.06 angle 80 points 16 density 30 cds 0.1 cds_points 8 hub_cds no "
               "sizes uniform 0.1 seed 5\n");
  scene.script(walls);
  scene.script(motion);
  scene.change([](int tag, double *, double *v) { v[0] = tag < 60 ? 0.5 : -0.5; });
}

DryScene::State after(int steps, MPI_Comm comm = MPI_COMM_WORLD)
{
  DryScene scene(comm);
  mixed_bed(scene);
  scene.script("run " + std::to_string(steps) + "\n");
  return scene.state();
}

/// Of all points on all ranks, by tag: n values of each.
std::map<int, std::vector<double>> by_tag(const DryScene &scene, double **values, int n)
{
  std::vector<double> all((scene.atom()->natoms + 1) * n, 0.0);
  for (int i = 0; i < scene.atom()->nlocal; i++) std::copy_n(values[i], n, &all[scene.atom()->tag[i] * n]);
  MPI_Allreduce(MPI_IN_PLACE, all.data(), all.size(), MPI_DOUBLE, MPI_SUM, scene.lmp()->world);
  std::map<int, std::vector<double>> columns;
  for (int tag = 1; tag <= scene.atom()->natoms; tag++) columns[tag].assign(&all[tag * n], &all[tag * n] + n);
  return columns;
}

std::map<int, std::vector<double>> columns(const DryScene &scene) { return by_tag(scene, scene.objects()->points(), FixObjects::N_COLUMNS); }
std::map<int, std::vector<double>> sizes(const DryScene &scene) { return by_tag(scene, scene.objects()->sizes(), FixObjects::N_SIZES); }

/// Entries of the pair style's list on all ranks, those with a point without a sphere apart.
std::array<int, 2> listed_pairs(const DryScene &scene)
{
  const LAMMPS_NS::NeighList *list = scene.lmp()->force->pair->list;
  std::array<int, 2> number{};
  double **points = scene.objects()->points();
  for (int n = 0; n < list->inum; n++)
    for (int k = 0, i = list->ilist[n]; k < list->numneigh[i]; k++) {
      const int j = list->firstneigh[i][k] & NEIGHMASK;
      number[points[i][FixObjects::HAS_CDS] == 0.0 || points[j][FixObjects::HAS_CDS] == 0.0]++;
    }
  MPI_Allreduce(MPI_IN_PLACE, number.data(), 2, MPI_INT, MPI_SUM, scene.lmp()->world);
  return number;
}

}  // namespace

TEST(DryShapes, PointsKnowTheirObject)
{
  DryScene scene;
  scene.box("0 1 0 1");
  scene.script("create_objects ellipse 0.5 0.4 axes 0.4 0.1 angle 90 points 16 density 1000 cds 0.05 reach 0.02\n");
  const auto state = scene.state();
  const auto points = columns(scene);
  ASSERT_EQ(state.size(), 17u);
  const double D = std::sqrt(0.04), offset = 0.03 * D;
  double mass = 0.0;
  for (const auto &[tag, point] : points) {
    mass += state.at(tag)[5];
    EXPECT_DOUBLE_EQ(point[FixObjects::DIAMETER], D);
    EXPECT_NEAR(state.at(tag)[0] - 0.5, point[FixObjects::REST_X], 1e-12);
    EXPECT_NEAR(state.at(tag)[1] - 0.4, point[FixObjects::REST_Y], 1e-12);
    EXPECT_EQ(point[FixObjects::SPOKES], 1.0);
    EXPECT_EQ(point[FixObjects::HAS_CDS], 1.0);
    EXPECT_DOUBLE_EQ(state.at(tag)[4], 0.05 * D);
    if (tag == 1) continue;
    const auto &next = state.at(tag < 17 ? tag + 1 : 2);
    EXPECT_NEAR(std::hypot(next[0] - state.at(tag)[0], next[1] - state.at(tag)[1]), point[FixObjects::RING_LENGTH], 1e-12);
    EXPECT_NEAR(std::hypot(state.at(tag)[0] - 0.5, state.at(tag)[1] - 0.4), point[FixObjects::SPOKE_LENGTH], 1e-12);
  }
  EXPECT_NEAR(mass, 1000 * pi * 0.2 * 0.05, 1e-9);
  // The tip points up, the flank to the left; at the flank the way to the hub is straight inwards.
  EXPECT_NEAR(state.at(2)[1] - 0.4 + points.at(2)[FixObjects::OUTLINE_OFFSET], 0.2, 1e-12);
  EXPECT_NEAR(0.5 - state.at(6)[0], 0.05 - offset, 1e-7);
  EXPECT_NEAR(points.at(6)[FixObjects::OUTLINE_OFFSET], offset, 1e-7);
}

TEST(DryShapes, OutlinesComeFromFilesAndTables)
{
  const std::string n = std::to_string(ranks()), star = "star_" + n + ".csv", table = "stars_" + n + ".csv";
  if (rank() == 0) {
    std::ofstream(star) << "x,y\n3,0\n1,1\n0,3\n-1,1\n-3,0\n-1,-1\n0,-3\n1,-1\n";
    std::ofstream(table) << "x,y,diameter,angle,points,reach\n0.25,0.25,0.2,0,8,0.05\n0.25,0.75,0.1,45,16,0.05\n0.75,0.5,0.2,0,0,0.03\n";
  }
  MPI_Barrier(MPI_COMM_WORLD);
  DryScene scene;
  scene.box("0 1 0 1");
  scene.script("create_objects file " + table + " outline " + star + " density 1000 cds 0.05\n");
  const auto state = scene.state();
  const auto points = columns(scene);
  ASSERT_EQ(state.size(), 9u + 17u + 9u);
  const double area = 3 * 4, scale = 0.2 / std::sqrt(4 * area / pi);  // of the star: 8 triangles of base 3, height 1
  EXPECT_NEAR(state.at(2)[0], 0.25 + 3 * scale, 1e-12);
  EXPECT_NEAR(state.at(3)[1], 0.25 + scale, 1e-12);
  EXPECT_NEAR(points.at(2)[FixObjects::NATURAL_AREA], 0.01 * pi, 1e-12);
  EXPECT_NEAR(state.at(11)[0], 0.25 + 3 * scale / 2 * std::sqrt(0.5), 1e-12) << "half as large, turned by 45 degrees";
  EXPECT_NEAR(state.at(11)[1], 0.75 + 3 * scale / 2 * std::sqrt(0.5), 1e-12);
  EXPECT_NEAR(state.at(28)[0] + points.at(28)[FixObjects::OUTLINE_OFFSET], 0.75 + 3 * scale, 1e-12);
  EXPECT_GT(points.at(28)[FixObjects::OUTLINE_OFFSET], 0.02 * 0.2);
  MPI_Barrier(MPI_COMM_WORLD);
  if (rank() == 0) std::remove(star.c_str()), std::remove(table.c_str());
}

TEST(DryShapes, RestWithoutForceAndTurnAsTheSolidShape)
{
  DryScene scene;
  scene.box("0 1 0 1");
  scene.script("create_objects ellipse 0.4 0.5 axes 0.3 0.1 angle 20 points 20 density 1000 cds 0.05\n"
               "fix springs all mass_spring stiffness 1e5\nfix move all nve/cds\ntimestep 1e-5\nrun 0\n");
  EXPECT_LT(scene.fix("springs")->compute_scalar(), 1e-20);
  // A blow at a tip: the linear and turning impulses of a solid ellipse.
  const double J = 0.05, M = 1000 * pi * 0.15 * 0.05, I = M * (0.15 * 0.15 + 0.05 * 0.05) / 4, c = std::cos(pi / 9), s = std::sin(pi / 9);
  const auto before = scene.state();
  scene.change([&](int tag, double *, double *v) {
    if (tag == 2) v[0] -= J * s / before.at(2)[5], v[1] += J * c / before.at(2)[5];
  });
  scene.script("run 2000\n");
  const auto state = scene.state();
  double L = 0.0, P[2] = {0.0, 0.0}, X[2] = {0.0, 0.0};
  for (const auto &[tag, values] : state)
    for (int d = 0; d < 2; d++) P[d] += values[5] * values[2 + d], X[d] += values[5] * values[d] / M;
  for (const auto &[tag, values] : state) L += values[5] * ((values[0] - X[0]) * values[3] - (values[1] - X[1]) * values[2]);
  EXPECT_NEAR(std::hypot(P[0], P[1]), J, 1e-10);
  EXPECT_NEAR(L, 0.15 * J, 1e-9);
  scene.objects()->update_rotations();
  EXPECT_NEAR(columns(scene).at(1)[FixObjects::ROTATION], 0.15 * J / I * 0.02, 0.01 * 0.15 * J / I * 0.02) << "but for vibrations";
}

TEST(DryShapes, RanksAgree)
{
  DryScene scene;
  mixed_bed(scene);
  scene.script("run 2500\n");
  EXPECT_GT(scene.fix("springs")->compute_scalar(), 1e-3) << "they have collided";
  EXPECT_LT(largest_difference(scene.state(), after(2500, MPI_COMM_SELF)), 1e-7);
}

TEST(DryShapes, AHubWithoutSpokesFollowsItsRingAcrossPeriodicSides)
{
  DryScene scene;
  scene.box("0 1 0 1", "p p p");
  scene.script("create_objects disk 0.9 0.9 diameter 0.3 points 24 density 100 cds 0.05 spokes no\n"
               "create_objects disk 0.4 0.4 diameter 0.3 points 24 density 100 cds 0.05 spokes no\n"
               "fix springs all mass_spring stiffness 100 restitution 0.9\nfix move all nve/cds\ntimestep 2e-4\n");
  const auto start = scene.state();
  scene.change([&](int tag, double *, double *v) {
    v[0] = 1.0 + 0.3 * std::sin(1.7 * tag), v[1] = (tag < 26 ? 0.7 : -0.7) + 0.3 * std::cos(2.3 * tag);
    if (tag == 1 || tag == 26) v[0] = v[1] = 1000.0;
  });
  for (int part = 0; part < 4; part++) {
    scene.script("run 700\n");
    const auto state = scene.state();
    for (const int hub : {1, 26}) {
      double mean[2] = {0.0, 0.0}, momentum = 0.0;
      for (int k = 1; k <= 24; k++) {
        for (int d = 0; d < 2; d++) mean[d] += state.at(hub + k)[d] / 24;
        momentum += state.at(hub + k)[5] * state.at(hub + k)[2];
      }
      EXPECT_NEAR(state.at(hub)[0], mean[0], 1e-12);
      EXPECT_NEAR(state.at(hub)[1], mean[1], 1e-12);
      EXPECT_NEAR(state.at(hub)[5], 1e-9 * 100 * pi * 0.0225, 1e-15);
      // Velocities of ring and hub are half a step apart.
      EXPECT_NEAR(momentum / (100 * pi * 0.0225), state.at(hub)[2], 1e-3);
    }
  }
  EXPECT_GT(scene.state().at(1)[0], start.at(1)[0] + 0.4) << "once around";
}

TEST(DryShapes, RestartsContinueTheRun)
{
  const std::string file = "shapes_" + std::to_string(ranks()) + ".restart";
  const auto whole = after(2000);
  {
    DryScene scene;
    mixed_bed(scene);
    scene.script("run 1000\nwrite_restart " + file + "\n");
  }
  DryScene scene;
  scene.script("atom_modify map array\nread_restart " + file + "\nnewton off\ncommunicate single vel yes\nsoft_particles yes\n");
  scene.settings();
  scene.script(walls);
  scene.script(motion);
  scene.script("run 1000\n");
  EXPECT_LT(largest_difference(scene.state(), whole), 1e-9);
  EXPECT_EQ(listed_pairs(scene)[1], 0) << "points without a sphere stay without neighbours";
  MPI_Barrier(MPI_COMM_WORLD);
  if (rank() == 0) std::remove(file.c_str());
}

TEST(DryShapes, PointsWithoutASphereHaveNoNeighbours)
{
  DryScene scene;
  scene.box("0 1 0 1", "f f p", "0.05");
  const std::string row = "create_objects lattice 4 4 origin 0.125 0.125 spacing 0.25 disk diameter 0.24 points 24 density 100 cds 0.05 ";
  scene.script(row + "cds_points 8 hub_cds no\nrun 0\n");
  const auto pairs = listed_pairs(scene);
  EXPECT_GT(pairs[0], 0);
  EXPECT_EQ(pairs[1], 0);
  const auto size = sizes(scene);
  for (const auto &[tag, point] : columns(scene)) {
    const bool sphere = (tag - 1) % 25 != 0 && ((tag - 1) % 25 - 1) % 3 == 0;
    EXPECT_EQ(point[FixObjects::HAS_CDS], sphere);
    EXPECT_DOUBLE_EQ(size.at(tag)[FixObjects::CDS_RADIUS], (sphere ? 1.0 : 1e-6) * 0.05 * 0.24);
  }
  DryScene all;
  all.box("0 1 0 1", "f f p", "0.05");
  all.script(row + "\nrun 0\n");
  EXPECT_GT(listed_pairs(all)[0], 4 * pairs[0]);
}

TEST(DryShapes, WithReachZeroOutlinesTouchWhenSpheresDo)
{
  DryScene scene;
  scene.box("0 1 0 1");
  scene.script("create_objects disk 0.3 0.5 diameter 0.2 points 20 density 100 cds 0.1 reach 0\n"
               "create_objects disk 0.502 0.5 diameter 0.2 points 20 density 100 cds 0.1 reach 0\nrun 0\n");
  for (const auto &[tag, force] : scene.forces()) EXPECT_EQ(force[0], 0.0);
  scene.change([](int tag, double *x, double *) { if (tag > 21) x[0] -= 0.003; });
  scene.script("run 0\n");
  const auto forces = scene.forces();
  EXPECT_NEAR(forces.at(2)[0], -1e4 * 0.001, 1e-9) << "kn times the overlap of the outlines";
  EXPECT_NEAR(forces.at(21 + 12)[0], 1e4 * 0.001, 1e-9);
}

TEST(DryShapes, SizesAreTheSameOnAnyNumberOfRanks)
{
  const auto made = [](MPI_Comm comm) {
    DryScene scene(comm);
    scene.box("0 1 0 1");
    scene.script("create_objects lattice 8 8 origin 0.06 0.06 spacing 0.12 disk diameter 0.06 points 8 density 100 sizes lognormal 0.2 seed 11\n");
    return scene.state();
  };
  const auto together = made(MPI_COMM_WORLD), alone = made(MPI_COMM_SELF);
  EXPECT_EQ(largest_difference(together, alone), 0.0);
  double sum = 0.0, squares = 0.0;
  for (int k = 0; k < 64; k++) {
    const double ratio = together.at(1 + 9 * k)[4] / (0.2 * 0.06);
    sum += ratio / 64, squares += ratio * ratio / 64;
  }
  EXPECT_NEAR(sum, 1.0, 0.1);
  EXPECT_NEAR(std::sqrt(squares - sum * sum), 0.2, 0.08);
}

TEST(DryShapes, ObjectsMadeEarlierCountWhereTheyAre)
{
  DryScene scene;
  scene.box("0 1 0 1", "p f p");
  scene.script("create_objects ellipse 0.5 0.5 axes 0.3 0.06 angle 45 points 24 density 100 cds 0.05\n"
               "create_objects ellipse 0.6 0.5 axes 0.3 0.06 angle 45 points 24 density 100 cds 0.05\n");
  EXPECT_EQ(scene.state().size(), 50u) << "their circles overlap, they do not";
  scene.script("fix move all nve/cds\ntimestep 1e-3\n");
  scene.change([](int, double *, double *v) { v[0] = 0.5; });
  scene.script("run 1000\ncreate_objects disk 0.5 0.5 diameter 0.1 density 100 cds 0.05\nrun 1\n");  // half a box further on
  EXPECT_EQ(scene.state().size(), 71u);
}

TEST(DryShapes, TenThousandEllipsesInUnderASecond)
{
  DryScene scene;
  scene.box("0 100 0 100", "f f p", "0.1");
  // Processor time of one rank: the machine may be busy with other things, and ranks may outnumber its cores.
  const std::clock_t start = std::clock();
  scene.script("create_objects lattice 100 100 origin 0.5 0.5 spacing 0.99 ellipse axes 1.2 0.5 angle 45 points 20 density 1500 cds 0.05 sizes normal 0.02 seed 1\n");
  const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  if (rank() == 0) std::printf("10,000 ellipses of 21 points made in %.3f s on %d ranks\n", seconds, ranks());
  EXPECT_EQ(scene.atom()->natoms, 210000);
#ifndef __SANITIZE_ADDRESS__
  if (ranks() == 1) {
    EXPECT_LT(seconds, 1.0);
  }
#endif
}
