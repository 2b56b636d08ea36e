// Growing radii must never lose a contact: against another object, a plane wall, a mesh wall; on any number of ranks.
#include "mesh_wall.h"
#include "pair_forces.h"

using namespace swellflow_test;

namespace {

/// Objects that stand still (no integrator) and grow, so that their spheres meet while nothing moves.
void grow(DryScene &scene, const std::string &law, int steps)
{
  scene.script("fix grow all swell " + law + "\ntimestep 1e-2\nrun " + std::to_string(steps) + "\n");
}

constexpr double kn = 1e4;

/// What a wall at `place` does to all spheres on its upper side in direction d.
Forces wall_forces(const DryScene::State &state, int d, double place)
{
  Forces forces;
  for (const auto &[tag, p] : state) forces[tag][d] = kn * std::max(p[4] - (p[d] - place), 0.0);
  return forces;
}

void expect_forces(const DryScene &scene, Forces expected)
{
  double largest = 0.0;
  for (const auto &[tag, f] : scene.forces())
    for (int d = 0; d < 2; d++) {
      EXPECT_NEAR(f[d], expected[tag][d], 1e-8) << "on atom " << tag << ", direction " << d;
      largest = std::max(largest, std::abs(f[d]));
    }
  EXPECT_GT(largest, 50.0) << "there must be contact to compare";
}

// Natural diameter 0.1, spheres of 0.01.
constexpr const char *disk = "diameter 0.1 points 20 density 1000 cds 0.1\n";

}  // namespace

struct Way {
  const char *name, *law;
  int steps;
};
void PrintTo(const Way &way, std::ostream *out) { *out << way.name; }

class Growing : public testing::TestWithParam<Way> {};

// Spheres of 0.01 at a distance of 0.06 touch when they have grown threefold.
TEST_P(Growing, PairContactsAreFound)
{
  DryScene scene;
  scene.box("0 1 0 1", "f f p", "0.002");
  scene.script(std::string("create_objects lattice 2 1 origin 0.42 0.5 spacing 0.16 disk ") + disk);
  grow(scene, GetParam().law, GetParam().steps);
  expect_forces(scene, pair_forces(scene.state(), 21, kn));
}

TEST_P(Growing, PlaneWallContactsAreFound)
{
  DryScene scene;
  scene.box("0 1 0 1", "f f p", "0.002");
  scene.script(std::string("create_objects disk 0.5 0.08 ") + disk +
               "fix bottom all wall/gran model hooke/stiffness tangential history primitive type 1 yplane 0.0 absolute_damping on\n");
  grow(scene, GetParam().law, GetParam().steps);
  expect_forces(scene, wall_forces(scene.state(), 1, 0.0));
}

TEST_P(Growing, MeshWallContactsAreFound)
{
  const std::string mesh = write_mesh("flat", {0.01, 0.3}, {0.99, 0.3});
  DryScene scene;
  scene.box("0 1 0 1", "f f p", "0.002", thick);
  scene.script(std::string("create_objects disk 0.5 0.38 ") + disk + "fix mesh all mesh/surface file " + mesh + " type 1\n" + mesh_wall);
  grow(scene, GetParam().law, GetParam().steps);
  expect_forces(scene, wall_forces(scene.state(), 1, 0.3));
  remove_mesh(mesh);
}

INSTANTIATE_TEST_SUITE_P(DryContacts, Growing,
                         testing::Values(Way{"slowly", "linear rate 0.1 max 0.37", 280}, Way{"fast", "linear rate 1.0 max 0.37", 30},
                                         Way{"far", "linear rate 0.1 max 0.5", 401}),
                         [](const auto &info) { return info.param.name; });

// The wall lies in the left half, the object in the right: its rank hears of the mesh only when spheres are large.
TEST(DryContacts, AMeshOnAnotherRankIsFoundLate)
{
  const std::string mesh = write_mesh("upright", {0.41, 0.4}, {0.41, 0.6});
  DryScene scene;
  scene.script("processors * 1 1\n");
  scene.box("0 1 0 1", "f f p", "0.002", thick);
  scene.script(std::string("create_objects disk 0.57 0.5 ") + disk + "fix mesh all mesh/surface file " + mesh + " type 1\n" + mesh_wall);
  grow(scene, "linear rate 0.4 max 1.3", 301);
  expect_forces(scene, wall_forces(scene.state(), 0, 0.41));
  remove_mesh(mesh);
}

// Other computes have neighbour lists of their own; they must outlive the new cut-offs.
TEST(DryContacts, ListsOfComputesSurviveTheGrowth)
{
  DryScene scene;
  scene.box("0 1 0 1", "f f p", "0.002");
  scene.script(std::string("create_objects lattice 2 1 origin 0.42 0.5 spacing 0.16 disk ") + disk +
               "compute touching all contact/atom\ncompute most all reduce max c_touching\n"
               "thermo_style custom step c_most\nthermo 1\nvariable most equal c_most\n");
  grow(scene, "linear rate 0.1 max 0.37", 280);
  int expected = 0;
  const auto state = scene.state();
  for (const auto &[a, p] : state) {
    int partners = 0;
    for (const auto &[b, q] : state)
      partners += (a - 1) / 21 != (b - 1) / 21 && std::hypot(p[0] - q[0], p[1] - q[1]) < p[4] + q[4];
    expected = std::max(expected, partners);
  }
  LAMMPS_NS::Variable *variable = scene.lmp()->input->variable;
  EXPECT_EQ(variable->compute_equal(variable->find(const_cast<char *>("most"))), expected);
}

namespace {

/// Swelling objects that press on each other and on walls, 200 steps.
DryScene::State bed_in_contact(MPI_Comm comm)
{
  DryScene scene(comm);
  scene.box("0 1 0 1");
  scene.script("create_objects lattice 4 4 origin 0.164 0.164 spacing 0.224 disk diameter 0.16 points 20 density 1500 cds 0.2 type 1\n"
               "fix springs all mass_spring stiffness 1000 restitution 0.9\nfix grow all swell linear rate 0.02 max 0.22\n"
               "fix move all nve/cds\nfix flat all enforce2d\ntimestep 2e-3\n");
  const char *sides[] = {"xplane 0.0", "xplane 1.0", "yplane 0.0", "yplane 1.0"};
  for (int k = 0; k < 4; k++)
    scene.script("fix side" + std::to_string(k) + " all wall/gran model hooke/stiffness tangential history primitive type 1 " +
                 sides[k] + " absolute_damping on\n");
  scene.change([](int tag, double *, double *v) { v[0] = 0.1 * std::sin(1.0 * tag), v[1] = 0.1 * std::cos(2.0 * tag); });
  scene.script("run 200\n");
  double largest = 0.0;
  for (const auto &[tag, f] : pair_forces(scene.state(), 21, kn)) largest = std::max(largest, std::hypot(f[0], f[1]));
  EXPECT_GT(largest, 10.0) << "there must be contact";
  return scene.state();
}

}  // namespace

TEST(DryContacts, ABedInContactDoesNotDependOnTheRanks)
{
  const double difference = largest_difference(bed_in_contact(MPI_COMM_WORLD), bed_in_contact(MPI_COMM_SELF));
  if (rank() == 0) std::printf("largest difference from one rank after 200 steps: %.2g\n", difference);
  EXPECT_LT(difference, 1e-9);
}

// Objects that drift over periodic sides, in contact, with their own atoms on both sides of the box.
TEST(DryContacts, APeriodicBedDoesNotDependOnTheRanks)
{
  const auto drifting_bed = [](MPI_Comm comm) {
    DryScene scene(comm);
    scene.box("0 1 0 1", "p p p");
    scene.script("create_objects lattice 4 4 origin 0.01 0.01 spacing 0.25 disk diameter 0.18 points 20 density 1500 cds 0.2 type 1\n"
                 "fix springs all mass_spring stiffness 1000 restitution 0.9\nfix grow all swell linear rate 0.02 max 0.22\n"
                 "fix move all nve/cds\ntimestep 2e-3\n");
    scene.change([](int tag, double *, double *v) { v[0] = 0.5 + 0.1 * std::sin(1.0 * tag), v[1] = -0.4 + 0.1 * std::cos(2.0 * tag); });
    scene.script("run 400\n");
    return scene.state();
  };
  const auto many = drifting_bed(MPI_COMM_WORLD);
  const double difference = largest_difference(many, drifting_bed(MPI_COMM_SELF));
  if (rank() == 0) std::printf("periodic: largest difference from one rank after 400 steps: %.2g\n", difference);
  EXPECT_LT(difference, 1e-9);
  std::array<double, 2> momentum{}, start{};
  for (const auto &[tag, p] : many)
    for (int d = 0; d < 2; d++) {
      momentum[d] += p[5] * p[2 + d];
      start[d] += p[5] * (d == 0 ? 0.5 : -0.4);
    }
  EXPECT_NEAR(momentum[0], start[0], 0.1 * start[0]) << "the drift must still be there";
}
