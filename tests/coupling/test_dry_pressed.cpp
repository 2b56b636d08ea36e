// Two objects that swell in a box until they press each other and the walls: balance of forces, energy, outlines that stay apart.
#include <numbers>

#include "dry_scene.h"

using namespace swellflow_test;
using LAMMPS_NS::FixObjects;

namespace {

constexpr double kn = 1e7, left = 0.2, right = 0.8, bottom = 0.1, top = 0.43;
constexpr int points = 21;  // of an object

using Point = std::array<double, 2>;
using Outline = std::vector<Point>;

class Pressed : public testing::TestWithParam<const char *> {};

/// Spheres of radius r in a row of pitch s let those of another row settle between them by 2r - sqrt(4 r^2 - s^2/4), here over D.
double settling()
{
  const double r = 0.14, s = 0.72 * std::sin(std::numbers::pi / 20.0);
  return 2.0 * r - std::sqrt(4.0 * r * r - 0.25 * s * s);
}

void press(DryScene &scene, const std::string &integrator, double reach)
{
  scene.box("0 1 0 0.5", "f f p", "0.01", "-0.05 0.05");
  scene.script("fix m1 all property/global kn peratomtypepair 1 1e7\n");
  const auto wall = [&](const std::string &plane, double at) {
    scene.script("fix " + plane + std::to_string(at).substr(2, 2) + " all wall/gran model hooke/stiffness tangential history primitive type 1 " + plane + " " +
                 std::to_string(at) + " absolute_damping on\n");
  };
  wall("xplane", left), wall("xplane", right), wall("yplane", bottom), wall("yplane", top);
  for (const std::string x : {"0.35", "0.65"})
    scene.script("create_objects disk " + x + " 0.265 diameter 0.25 points 20 density 1500 cds 0.14 reach " + std::to_string(reach) + "\n");
  scene.script("fix springs all mass_spring stiffness 1e5 restitution 0.5\nfix grow all swell linear rate 0.1 max 0.32\nfix move all " + integrator +
               "\nfix flat all enforce2d\ntimestep 5e-5\n");
}

/// Of the object whose hub has this tag, beyond its ring points by their offsets.
Outline outline(const DryScene &scene, const DryScene::State &state, int hub_tag)
{
  double offset = 0.0;
  for (int i = 0; i < scene.atom()->nlocal; i++)
    if (scene.atom()->tag[i] == hub_tag + 1) offset = scene.objects()->points()[i][FixObjects::OUTLINE_OFFSET] * scene.objects()->sizes()[i][FixObjects::LAMBDA];
  MPI_Allreduce(MPI_IN_PLACE, &offset, 1, MPI_DOUBLE, MPI_MAX, MPI_COMM_WORLD);
  const auto &hub = state.at(hub_tag);
  Outline outline;
  for (int k = 1; k < points; k++) {
    const auto &p = state.at(hub_tag + k);
    const double x = p[0] - hub[0], y = p[1] - hub[1], factor = 1.0 + offset / std::hypot(x, y);
    outline.push_back({hub[0] + factor * x, hub[1] + factor * y});
  }
  return outline;
}

/// How far the vertices of one convex outline lie inside another; 0 when they do not.
double penetration(const Outline &of, const Outline &into)
{
  double deepest = 0.0;
  for (const Point &p : of) {
    double depth = 1e300;
    for (std::size_t k = 0; k < into.size(); k++) {
      const Point &a = into[k], &b = into[(k + 1) % into.size()];
      const double ex = b[0] - a[0], ey = b[1] - a[1];
      depth = std::min(depth, (ex * (p[1] - a[1]) - ey * (p[0] - a[0])) / std::hypot(ex, ey));
    }
    deepest = std::max(deepest, depth);
  }
  return deepest;
}

struct Overlaps {
  double between = 0.0, energy = 0.0, wall_force[2] = {0.0, 0.0};
};

Overlaps overlaps(const DryScene::State &state)
{
  Overlaps found;
  for (const auto &[a, p] : state) {
    for (const auto &[b, q] : state) {
      if (a > points || b <= points) continue;
      const double overlap = std::max(0.0, p[4] + q[4] - std::hypot(p[0] - q[0], p[1] - q[1]));
      found.between = std::max(found.between, overlap);
      found.energy += 0.5 * kn * overlap * overlap;
    }
    const double at_walls[2][2] = {{left + p[4] - p[0], p[0] + p[4] - right}, {bottom + p[4] - p[1], p[1] + p[4] - top}};
    for (int d = 0; d < 2; d++)
      for (int side : {0, 1}) {
        const double overlap = std::max(0.0, at_walls[d][side]);
        found.wall_force[d] += (side == 0 ? kn : -kn) * overlap;
        found.energy += 0.5 * kn * overlap * overlap;
      }
  }
  return found;
}

double kinetic_energy(const DryScene::State &state)
{
  double energy = 0.0;
  for (const auto &[tag, p] : state) energy += 0.5 * p[5] * (p[2] * p[2] + p[3] * p[3]);
  return energy;
}

}  // namespace

TEST_P(Pressed, ForcesBalanceEnergyStaysBoundedAndOutlinesKeepApart)
{
  EXPECT_NEAR(settling(), 0.0057, 1e-4);
  for (double reach : {0.0, 0.5 * settling()}) {
    DryScene scene;
    press(scene, GetParam(), reach);
    double largest_energy = 0.0, pressing = 0.0;
    for (int part = 0; part < 16; part++) {
      scene.script("run 2000\n");
      const auto state = scene.state();
      const auto forces = scene.forces();
      const Overlaps now = overlaps(state);
      double size = 0.0;
      for (const auto &[tag, f] : forces) size += std::hypot(f[0], f[1]);
      for (int d = 0; d < 2; d++) {
        double sum = -now.wall_force[d];
        for (const auto &[tag, f] : forces) sum += f[d];
        const double overlap_digits = 1e-15 * kn;  // overlaps are differences of numbers of order 1
        EXPECT_LE(std::abs(sum), 1e-10 * size + overlap_digits) << "what the objects do to each other must cancel";
      }
      const Outline one = outline(scene, state, 1), two = outline(scene, state, 1 + points);
      // Linear contacts give way by force / kn; that, and how far spheres settle between others, a small reach makes up for.
      EXPECT_LE(std::max(penetration(one, two), penetration(two, one)), reach > 0.0 ? 0.0 : now.between + 0.32 * settling()) << "part " << part << ", reach " << reach;
      const double energy = kinetic_energy(state) + scene.fix("springs")->compute_scalar() + now.energy;
      if (part > 7) {
        EXPECT_LE(energy, 1.001 * largest_energy) << "growth is over";
      }
      largest_energy = std::max(largest_energy, energy);
      pressing = std::max(pressing, kn * now.between);
    }
    EXPECT_GT(pressing, 500.0) << "they must press each other";
    EXPECT_GT(largest_energy, 10.0);
  }
}

const std::string names[] = {"explicit_steps", "implicit", "conserving"};
INSTANTIATE_TEST_SUITE_P(Dry, Pressed, testing::Values("nve/cds", "nve/cds implicit", "nve/cds implicit energy conserve"),
                         [](const auto &info) { return names[info.index]; });
