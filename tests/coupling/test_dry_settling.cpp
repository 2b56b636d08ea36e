// A bed that is made at random falls, comes to rest and lies as loose beds do: on a floor between periodic sides, and on a mesh between walls.
#include <numbers>

#include "mesh_wall.h"
#include "pair_forces.h"

using namespace swellflow_test;
using std::numbers::pi;

namespace {

constexpr int n_objects = 60, ring_points = 24, atoms = ring_points + 1;
constexpr double D = 0.1, density = 1000.0, gravity = 9.81, kn = 3e6;
constexpr double weight = density * pi * D * D / 4 * gravity;

std::string plane(const std::string &name, const std::string &where)
{
  return "fix " + name + " all wall/gran model hooke/stiffness tangential history primitive type 1 " + where + " absolute_damping on\n";
}

class Bed : public DryScene {
public:
  Bed(const std::string &boundary, const std::string &walls, double floor)
  {
    script("units si\ndimension 2\natom_style hybrid granular molecular\natom_modify map array\nboundary " + boundary +
           "\nnewton off\ncommunicate single vel yes\nsoft_particles yes\nregion box block 0 1 0 2 -0.5 0.5 units box\ncreate_box 1 box\n"
           "neighbor 0.01 bin\nneigh_modify delay 0 exclude molecule all\n"
           "fix m1 all property/global kn peratomtypepair 1 3e6\nfix m2 all property/global kt peratomtypepair 1 1e6\n"
           "fix m3 all property/global gamman_abs peratomtypepair 1 5e3\nfix m4 all property/global gammat_abs peratomtypepair 1 1e3\n"
           "fix m5 all property/global coefficientFriction peratomtypepair 1 0.3\n"
           "pair_style gran model hooke/stiffness tangential history absolute_damping on\npair_coeff * *\n");
    script("create_objects random number " + std::to_string(n_objects) + " within rectangle 0 1 " + std::to_string(floor) + " 1.7 disk diameter 0.1 points " +
           std::to_string(ring_points) + " density 1000 cds 0.12 reach 0 gap 0.005 seed 5\n");
    script(walls + "fix flat all enforce2d\nfix weight all gravity 9.81 vector 0 -1 0\nfix move all rigid/cds spin body\n"
           "fix sums all output/objects every 1\nthermo_style custom step f_sums[9] f_sums[18]\ntimestep 2.5e-4\n");
  }

  void run(int steps) { script("thermo " + std::to_string(steps) + "\nrun " + std::to_string(steps) + "\n"); }
  double kinetic_energy() { return fix("sums")->compute_vector(8); }
  double mean_height() { return fix("sums")->compute_vector(17); }
};

/// Largest overlap of spheres of two objects.
double deepest(const DryScene::State &state, double period)
{
  double deepest = 0.0;
  for (const auto &[a, p] : state)
    for (const auto &[b, q] : state) {
      if ((a - 1) / atoms >= (b - 1) / atoms) continue;
      double dx = p[0] - q[0];
      if (period > 0.0) dx -= period * std::round(dx / period);
      deepest = std::max(deepest, p[4] + q[4] - std::hypot(dx, p[1] - q[1]));
    }
  return deepest;
}

/// Share of the area between two heights that discs cover.
double solid_fraction(const DryScene::State &state, double low, double high)
{
  constexpr int lines = 400;
  double covered = 0.0;
  for (int line = 0; line < lines; line++) {
    const double y = low + (line + 0.5) / lines * (high - low);
    for (const auto &[tag, p] : state)
      if ((tag - 1) % atoms == 0 && std::abs(p[1] - y) < D / 2) covered += 2 * std::sqrt(D * D / 4 - (p[1] - y) * (p[1] - y)) / lines;
  }
  return covered;  // over a width of 1
}

void expect_rest(Bed &bed, double period)
{
  const double fallen = n_objects * weight * 0.5;  // energy of a fall by half of the height, the order of what was there
  bed.run(2400);
  const double moving = bed.kinetic_energy();
  bed.run(4000);
  EXPECT_GT(moving, 1e-4 * fallen);
  EXPECT_LT(bed.kinetic_energy(), 1e-6 * fallen);
  const auto state = bed.state();
  EXPECT_EQ(state.size(), n_objects * static_cast<std::size_t>(atoms));
  // Some seven discs lie above each other, and chains of contacts carry a few times the mean.
  EXPECT_LT(deepest(state, period), 3 * 7 * weight / kn);
  EXPECT_GT(deepest(state, period), weight / kn);
}

}  // namespace

TEST(Settling, OnAFloorBetweenPeriodicSides)
{
  Bed bed("p f p", plane("floor", "yplane 0.0") + plane("lid", "yplane 2.0"), 0.0);
  bed.run(0);
  const double start = bed.mean_height();
  expect_rest(bed, 1.0);
  EXPECT_LT(bed.mean_height(), start);
  // Random loose packings of discs with friction have 0.77 to 0.84; a bed of equal ones may have crystalline parts.
  const double fraction = solid_fraction(bed.state(), D, 4 * D);
  EXPECT_GT(fraction, 0.74);
  EXPECT_LT(fraction, 0.89);
}

TEST(Settling, OnAMeshBetweenWalls)
{
  const std::string mesh = write_mesh("slope", {0.0, 0.1}, {1.0, 0.2});
  Bed bed("f f p", "fix mesh all mesh/surface file " + mesh + " type 1\n" + mesh_wall + plane("left", "xplane 0.0") + plane("right", "xplane 1.0") + plane("lid", "yplane 2.0"), 0.25);
  expect_rest(bed, 0.0);
  const auto state = bed.state();
  for (const auto &[tag, p] : state)
    if ((tag - 1) % atoms == 0) {
      EXPECT_GT((p[1] - 0.1 - 0.1 * p[0]) / std::hypot(1.0, 0.1), 0.49 * D) << "none has gone through the mesh";
    }
  const double fraction = solid_fraction(state, 0.1 + 2 * D, 0.1 + 4 * D);
  EXPECT_GT(fraction, 0.72);
  EXPECT_LT(fraction, 0.89);
  remove_mesh(mesh);
}
