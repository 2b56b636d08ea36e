// Discs, their growth in time, and what their outline says.
#include <gtest/gtest.h>

#include "liggghts_plugins/objects/disk.h"
#include "liggghts_plugins/objects/outline.h"
#include "liggghts_plugins/objects/overlap.h"
#include "liggghts_plugins/objects/swelling_laws.h"

using namespace swellflow;
using std::numbers::pi;

TEST(Disk, HasTheMassAndInertiaOfTheSolidDisc)
{
  const Disk disk{.diameter = 0.12, .ring_points = 20, .density = 1500.0};
  const double M = 1500.0 * pi * 0.0036;
  EXPECT_NEAR(disk.hub_mass() + 20 * disk.ring_point_mass(), M, 1e-12 * M);
  EXPECT_NEAR(20 * disk.ring_point_mass() * 0.0036, 0.5 * M * 0.0036, 1e-12 * M) << "the ring must carry M R^2 / 2";
}

TEST(Disk, EqualSharesAreThePapers)
{
  const Disk disk{.diameter = 0.12, .ring_points = 20, .density = 1500.0, .share = MassShare::equal};
  EXPECT_DOUBLE_EQ(disk.hub_mass(), disk.mass() / 21);
  EXPECT_DOUBLE_EQ(disk.ring_point_mass(), disk.mass() / 21);
}

TEST(Disk, HubIsTouchedLast)
{
  for (double ratio : {0.05, 0.2, 0.4}) {
    const Disk disk{.diameter = 1.0, .ring_points = 20, .density = 1.0, .cds_ratio = ratio};
    // A foreign sphere of the same size that comes in halfway between two ring points touches these when it is this far from the hub.
    const double half_gap = 0.5 * disk.ring_spring_length(), touch = 2 * disk.cds_radius();
    const double at_ring = 0.5 * std::cos(pi / 20) + std::sqrt(touch * touch - half_gap * half_gap);
    EXPECT_GT(at_ring, touch + 0.4) << "the ring must be met before the hub";
  }
}

TEST(LinearSwelling, ReachesItsCeilingExactlyAndStays)
{
  const LinearSwelling law{.rate = 6e-4, .largest_diameter = 0.18};
  EXPECT_EQ(law.diameter(0.12, 0.0), 0.12);
  EXPECT_NEAR(law.diameter(0.12, 50.0), 0.15, 1e-15);
  EXPECT_EQ(law.diameter(0.12, 100.1), 0.18);
  EXPECT_EQ(law.diameter(0.12, 1e9), 0.18);
  const double lambda = law.diameter(0.12, 110.0) / 0.12;
  EXPECT_NEAR(lambda * 0.12, 0.18, 1e-16 * 2);
}

TEST(SwellingClock, CountsOnOverChangesOfTheStep)
{
  SwellingClock clock{.base_time = 0.0, .base_step = 100, .step_length = 0.5};
  EXPECT_EQ(clock.time(110), 5.0);
  clock.change_step_length(110, 0.1);
  EXPECT_EQ(clock.time(110), 5.0);
  EXPECT_DOUBLE_EQ(clock.time(120), 6.0);
  clock.renumber(0, 120);
  EXPECT_DOUBLE_EQ(clock.time(0), 6.0);
  EXPECT_DOUBLE_EQ(clock.time(10), 7.0);
}

TEST(SwellingClock, TwoPartsAreOne)
{
  SwellingClock one{.base_time = 0.0, .base_step = 0, .step_length = 5e-3}, two = one;
  for (long step = 0; step < 22000; step += 777) two.change_step_length(step, 5e-3);
  EXPECT_EQ(one.time(22000), two.time(22000));
}

namespace {

std::vector<Vector2> ellipse(int N, double a, double b, double angle, const Vector2 &centre)
{
  std::vector<Vector2> ring;
  for (int k = 0; k < N; ++k) {
    const double t = 2 * pi * k / N, x = a * std::cos(t), y = b * std::sin(t);
    ring.push_back(centre + Vector2(x * std::cos(angle) - y * std::sin(angle), x * std::sin(angle) + y * std::cos(angle)));
  }
  return ring;
}

}  // namespace

TEST(Outline, OfACircleGivesItsDiameterAndNoElongation)
{
  for (int N : {3, 4, 20, 70}) {
    const OutlineShape shape = outline_shape(ellipse(N, 0.09, 0.09, 0.3, {0.01, -0.02}));
    EXPECT_NEAR(diameter_of_area(shape.area, regular_polygon_area(N, 1.0), 1.0), 0.18, 1e-12);
    EXPECT_NEAR(shape.aspect_ratio, 1.0, 1e-6);
  }
}

TEST(Outline, OfAnEllipseGivesItsAxes)
{
  for (double angle : {0.0, 0.4, 1.9}) {
    const OutlineShape shape = outline_shape(ellipse(20, 0.3, 0.1, angle, {0.05, 0.07}));
    EXPECT_NEAR(shape.aspect_ratio, 3.0, 1e-9);
    EXPECT_NEAR(shape.area, 20 * 0.3 * 0.1 / 2 * std::sin(2 * pi / 20), 1e-12);
  }
}

TEST(Outline, TurnedInsideOutIsNegative)
{
  std::vector<Vector2> ring = ellipse(12, 1, 1, 0, {0, 0});
  std::reverse(ring.begin(), ring.end());
  EXPECT_LT(outline_shape(ring).area, 0.0);
}

TEST(Overlap, IsFoundOnceAcrossPeriodicSidesAndNotForTouching)
{
  const PlaneBox box{.low = {0, 0}, .high = {1, 1}, .periodic = {true, false}};
  EXPECT_FALSE(deepest_overlap({{{0.2, 0.5}, 0.1}, {{0.4, 0.5}, 0.1}}, 0, box));
  const auto direct = deepest_overlap({{{0.2, 0.5}, 0.1}, {{0.39, 0.5}, 0.1}, {{0.8, 0.8}, 0.05}}, 0, box);
  ASSERT_TRUE(direct);
  EXPECT_EQ(direct->first, 0);
  EXPECT_EQ(direct->second, 1);
  EXPECT_NEAR(direct->depth, 0.01, 1e-12);
  EXPECT_TRUE(deepest_overlap({{{0.05, 0.5}, 0.1}, {{0.95, 0.5}, 0.1}}, 0, box));
  EXPECT_FALSE(deepest_overlap({{{0.5, 0.05}, 0.1}, {{0.5, 0.95}, 0.1}}, 0, box));
  EXPECT_FALSE(deepest_overlap({{{0.2, 0.5}, 0.1}, {{0.25, 0.5}, 0.1}, {{0.7, 0.5}, 0.1}}, 2, box)) << "old ones are not asked";
}

TEST(Overlap, AgreesWithAskingEveryPair)
{
  const PlaneBox box{.low = {-1, 0}, .high = {3, 2}, .periodic = {true, true}};
  unsigned seed = 12345;
  const auto random = [&] { return (seed = seed * 1664525u + 1013904223u) / 4294967296.0; };
  for (int round = 0; round < 50; ++round) {
    std::vector<Circle> circles;
    for (int k = 0; k < 40; ++k) circles.push_back({{-1 + 4 * random(), 2 * random()}, 0.02 + 0.1 * random()});
    double deepest = 0.0;
    for (std::size_t i = 0; i < circles.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        deepest = std::max(deepest, circles[i].radius + circles[j].radius - box.difference(circles[i].centre, circles[j].centre).norm());
    const auto found = deepest_overlap(circles, 0, box);
    EXPECT_NEAR(found ? found->depth : 0.0, deepest, 1e-12);
  }
}
