// Objects at random places: the same on any number of ranks, within boxes, rectangles and regions, and beside what is there.
#include <fstream>
#include <numbers>

#include "dry_scene.h"

using namespace swellflow_test;
using std::numbers::pi;

namespace {

constexpr int ring_points = 16, atoms = ring_points + 1;
const std::string disc = " disk points 16 density 1000 cds 0.1 reach 0 ";

/// Centre and radius of each object, the latter from its first ring point, whose sphere ends at the outline.
struct Disc {
  double x, y, R;
};
std::vector<Disc> discs_of(const DryScene::State &state, int first = 1)
{
  std::vector<Disc> discs;
  for (auto hub = state.find(first); hub != state.end(); hub = state.find(hub->first + atoms)) {
    const auto &ring = state.at(hub->first + 1);
    discs.push_back({hub->second[0], hub->second[1], std::hypot(ring[0] - hub->second[0], ring[1] - hub->second[1]) + ring[4]});
  }
  return discs;
}

double least_gap(const std::vector<Disc> &discs, double period = 0.0)
{
  double least = 1e300;
  for (std::size_t i = 0; i < discs.size(); i++)
    for (std::size_t j = 0; j < i; j++) {
      double dx = discs[i].x - discs[j].x;
      if (period > 0.0) dx -= period * std::round(dx / period);
      least = std::min(least, std::hypot(dx, discs[i].y - discs[j].y) - discs[i].R - discs[j].R);
    }
  return least;
}

double area_of(const std::vector<Disc> &discs)
{
  double sum = 0.0;
  for (const Disc &disc : discs) sum += pi * disc.R * disc.R;
  return sum;
}

}  // namespace

TEST(CreateRandom, IsTheSameOnAnyRanksAndGrids)
{
  const std::string line = "create_objects random solid_fraction 0.6 within box" + disc + "diameter 0.06 sizes lognormal 0.15 seed 3 seed 7 gap 1e-3\n";
  DryScene alone(MPI_COMM_SELF);
  alone.box("0 1 0 1", "p f p");
  alone.script(line);
  for (const char *grid : {"* * 1", "1 * 1", "* 1 1"}) {
    DryScene scene;
    scene.script(std::string("processors ") + grid + "\n");
    scene.box("0 1 0 1", "p f p");
    scene.script(line);
    EXPECT_EQ(largest_difference(scene.state(), alone.state()), 0.0) << grid;
  }
  const std::vector<Disc> discs = discs_of(alone.state());
  EXPECT_NEAR(area_of(discs), 0.6, 1e-9);
  EXPECT_GE(least_gap(discs, 1.0), 1e-3 - 1e-12);
}

TEST(CreateRandom, KeepsToARectangle)
{
  DryScene scene;
  scene.box("0 1 0 1");
  scene.script("create_objects random number 40 within rectangle 0.1 0.6 0.2 0.9" + disc + "diameter 0.07 seed 7 gap 0.004\n");
  const std::vector<Disc> discs = discs_of(scene.state());
  ASSERT_EQ(discs.size(), 40u);
  EXPECT_GE(least_gap(discs), 0.004 - 1e-12);
  for (const auto &[x, y, R] : discs) {
    EXPECT_NEAR(R, 0.035, 1e-12);
    EXPECT_GE(std::min({x - 0.1, 0.6 - x, y - 0.2, 0.9 - y}) - R, 0.004 - 1e-12);
  }
}

TEST(CreateRandom, KeepsToARegion)
{
  DryScene scene;
  scene.box("0 1 0 1");
  scene.script("region drum cylinder z 0.5 0.45 0.4 INF INF units box\n"
               "create_objects random solid_fraction 0.55 within region drum" + disc + "diameter 0.05 seed 7 gap 0.002\n");
  const std::vector<Disc> discs = discs_of(scene.state());
  EXPECT_NEAR(area_of(discs), 0.55 * pi * 0.16, 1e-4 * 0.55 * pi * 0.16);
  EXPECT_GE(least_gap(discs), 0.002 - 1e-12);
  for (const auto &[x, y, R] : discs) EXPECT_LE(std::hypot(x - 0.5, y - 0.45) + R, 0.4 - 0.002 + 1e-12);
}

// Outside of a region, and between regions: both are regions of their own to LIGGGHTS.
TEST(CreateRandom, KeepsOutOfARegion)
{
  DryScene scene;
  scene.box("0 1 0 1");
  scene.script("region stone sphere 0.4 0.5 0 0.2 side out units box\nregion slab block INF INF 0.1 0.9 INF INF units box\nregion both intersect 2 stone slab\n"
               "create_objects random number 60 within region both" + disc + "diameter 0.06 seed 7\n");
  const std::vector<Disc> discs = discs_of(scene.state());
  ASSERT_EQ(discs.size(), 60u);
  EXPECT_GE(least_gap(discs), -1e-12);
  for (const auto &[x, y, R] : discs) {
    EXPECT_GE(std::hypot(x - 0.4, y - 0.5) - R, 0.2 - 1e-12);
    EXPECT_GE(std::min({x, 1 - x, y - 0.1, 0.9 - y}) - R, -1e-12);
  }
}

// A block that ends at the periodic sides goes on there.
TEST(CreateRandom, GoesOnAcrossPeriodicSidesInARegion)
{
  DryScene scene;
  scene.box("0 1 0 1", "p f p");
  scene.script("region slab block 0 1 0.2 0.8 -1 1 units box\ncreate_objects random solid_fraction 0.6 within region slab" + disc + "diameter 0.05 seed 7\n");
  const std::vector<Disc> discs = discs_of(scene.state());
  EXPECT_GE(least_gap(discs, 1.0), -1e-12);
  int across = 0;
  for (const auto &[x, y, R] : discs) across += x < R || x > 1 - R;
  EXPECT_GT(across, 3);
}

TEST(CreateRandom, AvoidsObjectsThatAreThere)
{
  DryScene scene;
  scene.box("0 1 0 1", "p f p");
  scene.script("create_objects lattice 5 1 origin 0.1 0.5 spacing 0.2 ellipse axes 0.12 0.08 points 16 density 1000 cds 0.1 reach 0\n"
               "create_objects random number 150 within box" + disc + "diameter 0.05 seed 7 gap 0.002\n");  // the command itself refuses overlap
  EXPECT_EQ(scene.atom()->natoms, 155 * atoms);
  EXPECT_GE(least_gap(discs_of(scene.state(), 1 + 5 * atoms), 1.0), 0.002 - 1e-12);
}

// By default spheres reach beyond outlines: they are kept apart, too.
TEST(CreateRandom, KeepsSpheresApart)
{
  DryScene scene;
  scene.box("0 1 0 1");
  scene.script("create_objects random number 60 within box disk points 16 density 1000 cds 0.2 diameter 0.06 seed 7\nfix hold all held\nrun 0\n");
  for (const auto &[tag, force] : scene.forces()) EXPECT_EQ(std::hypot(force[0], force[1]), 0.0);
  EXPECT_GE(least_gap(discs_of(scene.state())), -1e-12) << "spheres included";
}

TEST(CreateRandom, OfOutlinesIsWithoutOverlap)
{
  const std::string name = "cross_" + std::to_string(ranks()) + ".csv";
  if (rank() == 0) std::ofstream(name) << "x,y\n2,-1\n2,1\n1,1\n1,2\n-1,2\n-1,1\n-2,1\n-2,-1\n-1,-1\n-1,-2\n1,-2\n1,-1\n";
  MPI_Barrier(MPI_COMM_WORLD);
  for (const std::string &shape : {"outline " + name + " diameter 0.15 points 24", std::string("ellipse axes 0.25 0.1 points 24")}) {
    DryScene scene;
    scene.box("0 1 0 1", "p p p");
    // The command's own check, by polygons, would refuse overlap.
    scene.script("create_objects random number 14 within box " + shape + " density 1000 cds 0.06 reach 0 seed 7\n");
    EXPECT_EQ(scene.atom()->natoms, 14 * 25);
  }
  MPI_Barrier(MPI_COMM_WORLD);
  if (rank() == 0) std::remove(name.c_str());
}
