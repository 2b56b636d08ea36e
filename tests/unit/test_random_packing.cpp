// Bodies at random places: apart, as dense as asked for, and by chance.
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

#include "liggghts_plugins/objects/circle_cover.h"
#include "liggghts_plugins/objects/outline.h"
#include "liggghts_plugins/objects/random_packing.h"
#include "liggghts_plugins/objects/size_distribution.h"
#include "complaints.h"

using namespace swellflow;
using namespace swellflow_test;
using std::numbers::pi;

namespace {

const auto disc = std::make_shared<const std::vector<Circle>>(1, Circle{Vector2::Zero(), 0.5});

Polygon ellipse(double ratio)
{
  Polygon outline;
  const double a = 0.5 * std::sqrt(ratio), b = 0.5 / std::sqrt(ratio);
  for (int k = 0; k < 32; ++k) outline.push_back({a * std::cos(2 * pi * k / 32), b * std::sin(2 * pi * k / 32)});
  return outline;
}

const Polygon star = {{0.6, 0}, {0.15, 0.15}, {0, 0.6}, {-0.15, 0.15}, {-0.6, 0}, {-0.15, -0.15}, {0, -0.6}, {0.15, -0.15}};

struct Scene {
  int n = 400;
  double fraction = 0.5;
  double spread = 0.0;
  double gap = 0.0;
  std::array<bool, 2> periodic{true, true};
  int seed = 1;
};

constexpr double width = 2.0, height = 1.0;

PackingTask task_of(const Scene &scene, const std::shared_ptr<const std::vector<Circle>> &cover = disc)
{
  PackingTask task;
  task.room = std::make_shared<RectangularRoom>(PlaneBox{{0, 0}, {width, height}, scene.periodic});
  task.seed = scene.seed;
  const SizeDistribution sizes{.kind = SizeDistribution::lognormal, .spread = scene.spread, .seed = 5};
  double squares = 0.0;
  for (int k = 0; k < scene.n; ++k) squares += std::pow(sizes.factor(k), 2);
  const double diameter = std::sqrt(scene.fraction * width * height / (pi / 4 * squares));
  for (int k = 0; k < scene.n; ++k) task.items.push_back({cover, diameter * sizes.factor(k), 0.5 * scene.gap, scene.gap});
  return task;
}

/// Of discs: least distance of two outlines, and of one from a wall.
std::pair<double, double> least_gaps(const PackingTask &task, const Packing &packing)
{
  const PlaneBox &box = task.room->box();
  double between = 1e300, to_wall = 1e300;
  for (std::size_t i = 0; i < task.items.size(); ++i) {
    const Vector2 &x = packing.placements[i].centre;
    const double R = 0.5 * task.items[i].size;
    for (std::size_t j = 0; j < i; ++j)
      between = std::min(between, box.difference(x, packing.placements[j].centre).norm() - R - 0.5 * task.items[j].size);
    for (const Circle &circle : task.obstacles) between = std::min(between, box.difference(x, circle.centre).norm() - R - circle.radius);
    for (int d = 0; d < 2; ++d)
      if (!box.periodic[d]) to_wall = std::min({to_wall, x[d] - R - box.low[d], box.high[d] - x[d] - R});
  }
  return {between, to_wall};
}

/// Share of its area that discs cover in each of `n` layers of the height, by lines across them.
std::vector<double> layers(const PackingTask &task, const Packing &packing, int n)
{
  constexpr int lines = 100;
  std::vector<double> covered(n, 0.0);
  for (std::size_t i = 0; i < task.items.size(); ++i)
    for (int line = 0; line < n * lines; ++line) {
      const double y = (line + 0.5) / (n * lines) * height, off = task.room->box().difference({0, y}, packing.placements[i].centre).y();
      const double R = 0.5 * task.items[i].size;
      if (std::abs(off) < R) covered[line / lines] += 2 * std::sqrt(R * R - off * off) / (lines * width);
    }
  return covered;
}

/// Mean over discs of the number of others within a ring about them, over that of points without rule.
double pair_correlation(const PackingTask &task, const Packing &packing, double from, double to)
{
  const auto n = static_cast<double>(task.items.size());
  int pairs = 0;
  for (std::size_t i = 0; i < task.items.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const double r = task.room->box().difference(packing.placements[i].centre, packing.placements[j].centre).norm();
      pairs += r >= from && r < to;
    }
  return 2.0 * pairs / (n * n / (width * height) * pi * (to * to - from * from));
}

}  // namespace

TEST(RandomPacking, IsFreeOfOverlapsAtAnyFraction)
{
  for (const double fraction : {0.1, 0.5, 0.7, 0.8})
    for (const double spread : {0.0, 0.3})
      for (const bool periodic : {true, false}) {
        const PackingTask task = task_of({.fraction = fraction, .spread = spread, .periodic = {periodic, periodic}});
        const Packing packing = pack_at_random(task);
        EXPECT_EQ(packing.scale, 1.0) << fraction << " " << spread;
        const auto [between, to_wall] = least_gaps(task, packing);
        EXPECT_GE(between, 0.0) << fraction << " " << spread;
        EXPECT_GE(to_wall, 0.0) << fraction << " " << spread;
        for (const Placement &placement : packing.placements) EXPECT_TRUE(placement.centre.x() >= 0 && placement.centre.x() < width && placement.centre.y() >= 0 && placement.centre.y() < height);
      }
}

TEST(RandomPacking, KeepsTheGap)
{
  const PackingTask task = task_of({.fraction = 0.5, .spread = 0.2, .gap = 0.01, .periodic = {true, false}});
  const auto [between, to_wall] = least_gaps(task, pack_at_random(task));
  EXPECT_GE(between, 0.01);
  EXPECT_GE(to_wall, 0.01);
  EXPECT_LT(between, 0.0105) << "so dense that some are that near";
}

TEST(RandomPacking, UsesPeriodicSides)
{
  const PackingTask task = task_of({.fraction = 0.7});
  int across = 0;
  for (const Placement &placement : pack_at_random(task).placements) across += placement.centre.y() < 0.5 * task.items[0].size;
  // A share R / height of all is expected, give or take the root of their number.
  const double expected = 400 * 0.5 * task.items[0].size / height;
  EXPECT_NEAR(across, expected, 3 * std::sqrt(expected));
}

TEST(RandomPacking, AvoidsWhatIsThere)
{
  PackingTask task = task_of({.n = 300, .fraction = 0.4, .periodic = {true, false}});
  for (int k = 0; k < 10; ++k) task.obstacles.push_back({{0.1 + 0.2 * k, 0.5}, 0.08});
  const auto [between, to_wall] = least_gaps(task, pack_at_random(task));
  EXPECT_GE(between, 0.0);
  EXPECT_GE(to_wall, 0.0);
}

TEST(RandomPacking, DependsOnTheSeedAlone)
{
  const Packing a = pack_at_random(task_of({})), b = pack_at_random(task_of({})), c = pack_at_random(task_of({.seed = 2}));
  double farthest = 0.0;
  for (std::size_t k = 0; k < a.placements.size(); ++k) {
    EXPECT_EQ(a.placements[k].centre, b.placements[k].centre);
    farthest = std::max(farthest, (a.placements[k].centre - c.placements[k].centre).norm());
  }
  EXPECT_GT(farthest, 0.3);
}

// In equilibrium the density at contact is that of Henderson, Molec. Phys. 30, 971 (1975): (1 - 7 phi / 16) / (1 - phi)^2; the mean over the first 5 % of a diameter is somewhat less.
TEST(RandomPacking, IsThatOfAHardDiscFluid)
{
  for (const double fraction : {0.1, 0.3, 0.5}) {
    double near = 0.0, far = 0.0;
    constexpr int seeds = 5;
    for (int seed = 1; seed <= seeds; ++seed) {
      const PackingTask task = task_of({.n = 1000, .fraction = fraction, .seed = seed});
      const Packing packing = pack_at_random(task);
      const double D = task.items[0].size;
      near += pair_correlation(task, packing, D, 1.05 * D) / seeds;
      far += pair_correlation(task, packing, 5 * D, 8 * D) / seeds;
    }
    const double at_contact = (1 - 7 * fraction / 16) / std::pow(1 - fraction, 2);
    EXPECT_NEAR(near, at_contact, 0.12 * at_contact) << fraction;
    EXPECT_NEAR(far, 1.0, 0.01) << fraction;
  }
}

TEST(RandomPacking, IsEvenlyDenseFromBottomToTop)
{
  const PackingTask task = task_of({.n = 2000, .fraction = 0.6, .spread = 0.1});
  for (const double covered : layers(task, pack_at_random(task), 5)) EXPECT_NEAR(covered, 0.6, 0.02);
}

// Dense, with different sizes: no crystal. The mean of exp(6 i angle) over all neighbours is 1 in one.
TEST(RandomPacking, HasNoLattice)
{
  const PackingTask task = task_of({.n = 1000, .fraction = 0.7, .spread = 0.2});
  const Packing packing = pack_at_random(task);
  std::complex<double> sum = 0.0;
  int pairs = 0;
  for (std::size_t i = 0; i < task.items.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const Vector2 way = task.room->box().difference(packing.placements[i].centre, packing.placements[j].centre);
      if (way.norm() > 0.6 * (task.items[i].size + task.items[j].size)) continue;
      sum += std::polar(1.0, 6 * std::atan2(way.y(), way.x()));
      ++pairs;
    }
  EXPECT_GT(pairs, 1500);
  EXPECT_LT(std::abs(sum) / pairs, 0.1);
}

TEST(RandomPacking, TellsHowMuchFits)
{
  const PackingTask task = task_of({.fraction = 0.95, .spread = 0.2});
  const Packing packing = pack_at_random(task);
  const double reached = 0.95 * packing.scale * packing.scale;
  EXPECT_GT(reached, 0.82);
  EXPECT_LT(reached, 0.88);
  PackingTask smaller = task;
  for (PackingItem &item : smaller.items) item.size *= packing.scale;
  EXPECT_GE(least_gaps(smaller, packing).first, 0.0) << "what it says is there";
}

TEST(RandomPacking, OfEllipsesTurnsThemEveryWay)
{
  const auto cover = std::make_shared<const std::vector<Circle>>(covering_circles(ellipse(2.0), 0.01));
  PackingTask task = task_of({.n = 200, .fraction = 0.7}, cover);
  task.turning = true;
  const Packing packing = pack_at_random(task);
  ASSERT_EQ(packing.scale, 1.0);
  std::vector<Footprint> footprints;
  std::complex<double> sum = 0.0;
  for (std::size_t k = 0; k < task.items.size(); ++k) {
    const auto &[centre, angle] = packing.placements[k];
    Footprint footprint{{centre, 0.0}, {}};
    for (const Vector2 &x : ellipse(2.0)) {
      const double c = std::cos(angle), s = std::sin(angle);
      footprint.outline.push_back(task.items[k].size * Vector2(c * x.x() - s * x.y(), s * x.x() + c * x.y()));
      footprint.circle.radius = std::max(footprint.circle.radius, footprint.outline.back().norm());
    }
    footprints.push_back(footprint);
    sum += std::polar(1.0 / 200, 2 * angle);
  }
  EXPECT_FALSE(deepest_overlap(footprints, 0, task.room->box()));
  EXPECT_LT(std::abs(sum), 0.2) << "200 without a preferred direction: 0.07 give or take";
}

TEST(CircleCover, CoversAnOutlineAndLittleElse)
{
  for (const Polygon &outline : {ellipse(1.0), ellipse(2.0), ellipse(4.0), star, Polygon{{-0.4, -0.4}, {0.4, -0.4}, {0.4, 0.4}, {-0.4, 0.4}}}) {
    const std::vector<Circle> cover = covering_circles(outline, 0.01);
    EXPECT_LT(cover.size(), 80u);
    for (std::size_t k = 0; k < outline.size(); ++k)
      for (int part = 0; part < 1000; ++part) {
        const Vector2 x = outline[k] + part / 1000.0 * (outline[after(outline, k)] - outline[k]);
        double deepest = -1.0;
        for (const Circle &circle : cover) deepest = std::max(deepest, circle.radius - (circle.centre - x).norm());
        EXPECT_GE(deepest, 0.0) << "at " << x.transpose();
      }
    for (const Circle &circle : cover)
      for (int k = 0; k < 100; ++k) {
        const Vector2 x = circle.centre + circle.radius * Vector2(std::cos(2 * pi * k / 100), std::sin(2 * pi * k / 100));
        EXPECT_TRUE(contains(outline, x) || distance_to_boundary(outline, x) <= 0.0101) << "at " << x.transpose();
      }
  }
}

TEST(CircleCover, OfAPolygonLikeADiscIsOneCircle)
{
  EXPECT_EQ(covering_circles(ellipse(1.0), 0.01).size(), 1u);
}

TEST(RandomPacking, RefusesARoomWithoutAPlaceInside)
{
  struct Nowhere : RectangularRoom {
    using RectangularRoom::RectangularRoom;
    bool contains(const Vector2 &) const override { return false; }
  };
  PackingTask task = task_of({});
  task.room = std::make_shared<Nowhere>(task.room->box());
  expect_all(complaint_of([&] { pack_at_random(task); }), {"space for objects"});
}
