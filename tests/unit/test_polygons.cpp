// Outlines as polygons: what they say of an object's size and shape, and which objects overlap.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "liggghts_plugins/objects/outline.h"
#include "liggghts_plugins/objects/outline_file.h"
#include "liggghts_plugins/objects/overlap.h"
#include "complaints.h"

using namespace swellflow;
using namespace swellflow_test;
using std::numbers::pi;

namespace {

Polygon ellipse(int N, double a, double b, double angle, const Vector2 &centre = {0, 0})
{
  Polygon ring;
  for (int k = 0; k < N; ++k) {
    const double t = 2 * pi * k / N, x = a * std::cos(t), y = b * std::sin(t);
    ring.push_back(centre + Vector2(x * std::cos(angle) - y * std::sin(angle), x * std::sin(angle) + y * std::cos(angle)));
  }
  return ring;
}

Footprint circle(double x, double y, double R) { return {{{x, y}, R}, {}}; }

Footprint covering(const Vector2 &centre, const Polygon &outline)
{
  double R = 0.0;
  for (const Vector2 &x : outline) R = std::max(R, x.norm());
  return {{centre, R}, outline};
}

const PlaneBox open_box{.low = {0, 0}, .high = {1, 1}};

double depth(const Footprint &a, const Footprint &b, const PlaneBox &box = open_box)
{
  const auto there = deepest_overlap({a, b}, 0, box), back = deepest_overlap({b, a}, 0, box);
  EXPECT_EQ(there.has_value(), back.has_value()) << "whichever comes first";
  if (there && back) {
    EXPECT_NEAR(there->depth, back->depth, 1e-9);
  }
  return there ? there->depth : 0.0;
}

const Polygon square = {{-0.1, -0.1}, {0.1, -0.1}, {0.1, 0.1}, {-0.1, 0.1}};
/// Open to the right; its centroid is not inside.
const Polygon bay = {{-0.2, -0.2}, {0.2, -0.2}, {0.2, -0.15}, {-0.15, -0.15}, {-0.15, 0.15}, {0.2, 0.15}, {0.2, 0.2}, {-0.2, 0.2}};

std::string complaint(const std::string &text)
{
  return complaint_of([&] { read_outline("star.csv", text); });
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
  Polygon ring = ellipse(12, 1, 1, 0);
  std::reverse(ring.begin(), ring.end());
  EXPECT_LT(outline_shape(ring).area, 0.0);
}

TEST(Polygon, KnowsInsideDistanceAndGyration)
{
  EXPECT_TRUE(contains(square, {0.09, -0.09}));
  EXPECT_FALSE(contains(square, {0.11, 0.0}));
  EXPECT_FALSE(contains(bay, {0.0, 0.0}));
  EXPECT_NEAR(distance_to_boundary(square, {0.03, 0.0}), 0.07, 1e-15);
  EXPECT_NEAR(distance_to_boundary(square, {0.4, 0.5}), 0.5, 1e-15);
  EXPECT_NEAR(mean_square_radius(square), (0.04 + 0.04) / 12, 1e-15);
  EXPECT_NEAR(mean_square_radius(ellipse(2000, 0.3, 0.1, 0.7)), (0.09 + 0.01) / 4, 1e-6);
}

TEST(Polygon, FindsWhereItCrossesOrTouchesItself)
{
  EXPECT_FALSE(self_intersection(square));
  EXPECT_FALSE(self_intersection(bay));
  EXPECT_FALSE(self_intersection({{0, 0}, {1, 0}, {2, 0}, {1, 1}})) << "a point on a straight side is none";
  EXPECT_EQ(self_intersection({{0, 0}, {1, 1}, {1, 0}, {0, 1}}), (std::pair<std::size_t, std::size_t>(0, 2)));
  EXPECT_TRUE(self_intersection({{0, 0}, {2, 0}, {2, 1}, {1, 0}, {0, 1}})) << "a corner on a side";
  EXPECT_TRUE(self_intersection({{0, 0}, {1, 0}, {1, 1}, {1, -1}, {0, -1}})) << "a side that folds back";
}

TEST(Overlap, OfCirclesIsFoundAcrossPeriodicSidesAndNotForTouching)
{
  const PlaneBox box{.low = {0, 0}, .high = {1, 1}, .periodic = {true, false}};
  EXPECT_FALSE(deepest_overlap({circle(0.2, 0.5, 0.1), circle(0.4, 0.5, 0.1)}, 0, box));
  const auto direct = deepest_overlap({circle(0.2, 0.5, 0.1), circle(0.39, 0.5, 0.1), circle(0.8, 0.8, 0.05)}, 0, box);
  ASSERT_TRUE(direct);
  EXPECT_EQ(direct->first, 0);
  EXPECT_EQ(direct->second, 1);
  EXPECT_NEAR(direct->depth, 0.01, 1e-12);
  EXPECT_TRUE(deepest_overlap({circle(0.05, 0.5, 0.1), circle(0.95, 0.5, 0.1)}, 0, box));
  EXPECT_FALSE(deepest_overlap({circle(0.5, 0.05, 0.1), circle(0.5, 0.95, 0.1)}, 0, box));
  EXPECT_FALSE(deepest_overlap({circle(0.2, 0.5, 0.1), circle(0.25, 0.5, 0.1), circle(0.7, 0.5, 0.1)}, 2, box)) << "old ones are not asked";
}

TEST(Overlap, AgreesWithAskingEveryPair)
{
  const PlaneBox box{.low = {-1, 0}, .high = {3, 2}, .periodic = {true, true}};
  unsigned seed = 12345;
  const auto random = [&] { return (seed = seed * 1664525u + 1013904223u) / 4294967296.0; };
  for (int round = 0; round < 50; ++round) {
    std::vector<Footprint> circles;
    for (int k = 0; k < 40; ++k) {
      const double x = -1 + 4 * random(), y = 2 * random();
      circles.push_back(circle(x, y, 0.02 + 0.1 * random()));
    }
    double deepest = 0.0;
    for (std::size_t i = 0; i < circles.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) {
        const Circle &a = circles[i].circle, &b = circles[j].circle;
        deepest = std::max(deepest, a.radius + b.radius - box.difference(a.centre, b.centre).norm());
      }
    const auto found = deepest_overlap(circles, 0, box);
    EXPECT_NEAR(found ? found->depth : 0.0, deepest, 1e-12);
  }
}

TEST(Overlap, EllipsesSideBySideMayShareTheirCircles)
{
  const Polygon upright = ellipse(24, 0.05, 0.15, 0.0), turned = ellipse(24, 0.05, 0.15, pi / 6);
  EXPECT_EQ(depth(covering({0.4, 0.5}, upright), covering({0.5, 0.5}, upright)), 0.0) << "they touch";
  EXPECT_NEAR(depth(covering({0.4, 0.5}, upright), covering({0.49, 0.5}, upright)), 0.01, 1e-3);
  EXPECT_EQ(depth(covering({0.4, 0.5}, turned), covering({0.52, 0.5}, turned)), 0.0);
  EXPECT_GT(depth(covering({0.4, 0.5}, upright), covering({0.45, 0.55}, turned)), 0.0);
  EXPECT_GT(depth(covering({0.4, 0.5}, upright), covering({0.4, 0.5}, ellipse(24, 0.15, 0.05, 0.0))), 0.04) << "a cross has no corner in the other";
  const PlaneBox periodic{.low = {0, 0}, .high = {1, 1}, .periodic = {true, true}};
  EXPECT_NEAR(depth(covering({0.01, 0.5}, upright), covering({0.92, 0.5}, upright), periodic), 0.01, 1e-3);
}

TEST(Overlap, OfPolygonsThatCoincideTouchOrHoldEachOther)
{
  EXPECT_GT(depth(covering({0.5, 0.5}, square), covering({0.5, 0.5}, square)), 0.0) << "twice the same";
  EXPECT_GT(depth(covering({0.5, 0.5}, bay), covering({0.5, 0.5}, bay)), 0.0) << "also when the centre is not inside";
  EXPECT_EQ(depth(covering({0.3, 0.5}, square), covering({0.5, 0.5}, square)), 0.0) << "a common side";
  EXPECT_EQ(depth(covering({0.3, 0.5}, square), covering({0.5, 0.6}, square)), 0.0) << "half a common side";
  EXPECT_NEAR(depth(covering({0.3, 0.5}, square), covering({0.48, 0.5}, square)), 0.02, 1e-6);
  const Polygon small = {{-0.02, -0.02}, {0.02, -0.02}, {0.02, 0.02}, {-0.02, 0.02}};
  EXPECT_GT(depth(covering({0.5, 0.5}, square), covering({0.55, 0.5}, small)), 0.02) << "one within the other";
  EXPECT_EQ(depth(covering({0.5, 0.5}, bay), covering({0.5, 0.5}, square)), 0.0) << "in the bay, not in the object";
}

TEST(Overlap, OfPolygonAndCircle)
{
  EXPECT_EQ(depth(covering({0.3, 0.5}, square), circle(0.5, 0.5, 0.1)), 0.0);
  EXPECT_NEAR(depth(covering({0.3, 0.5}, square), circle(0.5, 0.5, 0.13)), 0.03, 1e-12);
  EXPECT_EQ(depth(covering({0.3, 0.3}, square), circle(0.5, 0.5, 0.141)), 0.0) << "past the corner";
  EXPECT_NEAR(depth(covering({0.5, 0.5}, square), circle(0.5, 0.52, 0.01)), 0.09, 1e-12) << "within";
  EXPECT_EQ(depth(covering({0.5, 0.5}, bay), circle(0.5, 0.5, 0.14)), 0.0);
}

TEST(OutlineFile, IsReadEitherWayRound)
{
  const Polygon outline = read_outline("star.csv", "# clockwise\ny,x\n0,0\n1,0\n1,1\n");
  EXPECT_EQ(outline, (Polygon{{0, 0}, {0, 1}, {1, 1}}));
}

TEST(OutlineFile, ErrorsNameFileAndLine)
{
  expect_all(complaint("x,z\n0,0\n"), {"star.csv line 1", "'z'", "known are x, y"});
  expect_all(complaint("x\n0\n1\n2\n"), {"star.csv", "columns x and y", "'y' is missing"});
  expect_all(complaint("x,y\n0,0\n1,1\n"), {"star.csv line 3", "at least 3 points", "after 2", "add"});
  expect_all(complaint("x,y\n0,0\n1,0\n\n1,1\n0,0\n"), {"star.csv line 6", "each point once", "that of line 2", "leave it out"});
  expect_all(complaint("x,y\n0,0\n1,0\n0.5,0.5\n1,0\n0,1\n"), {"star.csv line 5", "each point once", "line 3"});
  expect_all(complaint("x,y\n0,0\n1,1\n1,0\n0,1\n"), {"star.csv line 4", "must not cross or touch itself", "begins at line 2", "correct"});
}
