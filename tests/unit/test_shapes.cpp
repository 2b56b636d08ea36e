// Shapes made of points: where these are, what they weigh, and how far their spheres reach.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "liggghts_plugins/objects/outline.h"
#include "liggghts_plugins/objects/shape.h"
#include "liggghts_plugins/objects/size_distribution.h"
#include "complaints.h"

using namespace swellflow;
using namespace swellflow_test;
using std::numbers::pi;

namespace {

std::shared_ptr<const Contour> disk() { return std::make_shared<Contour>(Contour::disk()); }
std::shared_ptr<const Contour> ellipse(double a, double b) { return std::make_shared<Contour>(Contour::ellipse(a, b)); }
std::shared_ptr<const Contour> outline(const Polygon &vertices) { return std::make_shared<Contour>(Contour::polygon(vertices)); }

Polygon star(int tips, double inner)
{
  Polygon star;
  for (int k = 0; k < 2 * tips; ++k) star.push_back((k % 2 ? inner : 1.0) * Vector2(std::cos(pi * k / tips), std::sin(pi * k / tips)));
  return star;
}

/// Neither symmetric nor convex.
const Polygon pear = {{0, 0}, {3, 0}, {4, 1}, {3.5, 2}, {2, 2}, {1.2, 3.5}, {0.4, 3}};
const Polygon bay = {{-2, -2}, {2, -2}, {2, -1.5}, {-1.5, -1.5}, {-1.5, 1.5}, {2, 1.5}, {2, 2}, {-2, 2}};

struct Solid {
  double mass = 0.0, inertia = 0.0;
  Vector2 centre = Vector2::Zero();
};

/// Of the points of an object of diameter D and density 1; inertia about their own centre.
Solid solid(const Shape &shape, double D)
{
  const double M = shape.mass(D, 1.0);
  std::vector<std::pair<double, Vector2>> points{{shape.hub_mass(M), D * shape.hub}};
  for (std::size_t k = 0; k < shape.ring.size(); ++k) points.emplace_back(shape.ring_point_mass(k, M), D * shape.ring[k].x);
  Solid solid;
  for (const auto &[m, x] : points) solid.mass += m, solid.centre += m * x;
  solid.centre /= solid.mass;
  for (const auto &[m, x] : points) solid.inertia += m * (x - solid.centre).squaredNorm();
  return solid;
}

std::string complaint(const ShapeRequest &request)
{
  return complaint_of([&] { make_shape(request); });
}

}  // namespace

TEST(Disk, HasTheMassAndInertiaOfTheSolidDisc)
{
  const Shape shape = make_shape({.contour = disk()});
  const double M = shape.mass(0.12, 1500.0);
  EXPECT_NEAR(M, 1500.0 * pi * 0.0036, 1e-12);
  EXPECT_EQ(shape.hub_mass(M), 0.5 * M);
  EXPECT_EQ(shape.ring_point_mass(7, M), 0.5 * M / 20);
  EXPECT_NEAR(solid(shape, 2.0).inertia, 0.5 * pi, 1e-12);
  EXPECT_EQ(shape.ring[0].ring_length, std::sin(pi / 20));
  EXPECT_EQ(shape.ring[3].spoke_length, 0.5);
  EXPECT_EQ(shape.natural_area(0.12), regular_polygon_area(20, 0.12));
}

TEST(Disk, EqualSharesAreThePapers)
{
  const Shape shape = make_shape({.contour = disk(), .share = MassShare::equal});
  EXPECT_EQ(shape.hub_mass(7.0), 7.0 / 21);
  EXPECT_DOUBLE_EQ(shape.ring_point_mass(3, 7.0), 7.0 / 21);
}

TEST(Disk, HubIsTouchedLast)
{
  for (double ratio : {0.05, 0.2, 0.4}) {
    const Shape shape = make_shape({.contour = disk(), .cds = ratio});
    // A foreign sphere of the same size that comes in halfway between two ring points touches these when it is this far from the hub.
    const double half_gap = 0.5 * shape.ring[0].ring_length, touch = 2 * ratio;
    const double at_ring = 0.5 * std::cos(pi / 20) + std::sqrt(touch * touch - half_gap * half_gap);
    EXPECT_GT(at_ring, touch + 0.4) << "the ring must be met before the hub";
  }
}

TEST(Disk, ReachPutsThePointsInsideAndKeepsMassAndInertia)
{
  const Shape shape = make_shape({.contour = disk(), .cds = 0.1, .reach = 0.02});
  for (const auto &point : shape.ring) {
    EXPECT_DOUBLE_EQ(point.x.norm() + 0.1, 0.5 + 0.02);
    EXPECT_DOUBLE_EQ(outline_point(point.x, point.outline_offset).norm(), 0.5);
  }
  EXPECT_DOUBLE_EQ(shape.ring[0].ring_length, 2 * 0.42 * std::sin(pi / 20));
  EXPECT_NEAR(solid(shape, 2.0).inertia, 0.5 * pi, 1e-12);
  EXPECT_EQ(shape.natural_area(2.0), regular_polygon_area(20, 2.0)) << "of the outline, not of the ring";
}

TEST(Ellipse, PointsAreAtEqualArcsOrAngles)
{
  const Shape arc = make_shape({.contour = ellipse(0.3, 0.1), .points = 200}), angle = make_shape({.contour = ellipse(0.3, 0.1), .spacing = PointSpacing::angle});
  const double a = 0.5 * std::sqrt(3.0), b = 0.25 / a;
  // The chords of equal arcs differ by their curvature only.
  double shortest = 1.0, longest = 0.0;
  for (const auto &point : arc.ring) {
    shortest = std::min(shortest, point.ring_length), longest = std::max(longest, point.ring_length);
    EXPECT_NEAR(std::hypot(point.x.x() / a, point.x.y() / b), 1.0, 1e-14);
  }
  EXPECT_LT(longest / shortest, 1.005);
  // The circumference by Ramanujan's second formula, good to 1e-6 here.
  const double h = std::pow((a - b) / (a + b), 2), round = pi * (a + b) * (1 + 3 * h / (10 + std::sqrt(4 - 3 * h)));
  EXPECT_NEAR(longest * 200, round, 1e-3);
  for (int k = 0; k < 20; ++k) {
    EXPECT_NEAR(std::remainder(std::atan2(angle.ring[k].x.y(), angle.ring[k].x.x()) - 2 * pi * k / 20, 2 * pi), 0.0, 1e-14);
    EXPECT_NEAR(std::hypot(angle.ring[k].x.x() / a, angle.ring[k].x.y() / b), 1.0, 1e-14);
  }
  EXPECT_NEAR(Contour::ellipse(0.3, 0.1).own_diameter(), std::sqrt(0.03), 1e-15);
}

TEST(Ellipse, IsADiscWhenItsAxesAreEqual)
{
  const Shape round = make_shape({.contour = disk()}), shape = make_shape({.contour = ellipse(2, 2)});
  for (int k = 0; k < 20; ++k) {
    EXPECT_NEAR((shape.ring[k].x - round.ring[k].x).norm(), 0.0, 1e-13);
    EXPECT_NEAR(shape.ring_point_mass(k, 1.0), round.ring_point_mass(k, 1.0), 1e-12);
    EXPECT_NEAR(shape.ring[k].ring_length, round.ring[k].ring_length, 1e-13);
  }
  EXPECT_NEAR(shape.natural_area(0.3), round.natural_area(0.3), 1e-14);
}

TEST(Shapes, HaveTheMassCentreAndInertiaOfTheSolidShape)
{
  const ShapeRequest requests[] = {{.contour = ellipse(0.3, 0.1)},
                                   {.contour = ellipse(0.1, 0.3), .points = 7},
                                   {.contour = ellipse(0.3, 0.2), .points = 15, .spacing = PointSpacing::angle},
                                   {.contour = ellipse(0.3, 0.2), .cds = 0.1, .reach = 0.05},
                                   {.contour = outline(star(5, 0.5)), .points = 40},
                                   {.contour = outline(pear), .points = 30},
                                   {.contour = outline(pear), .points = 24, .cds = 0.08, .reach = 0.03},
                                   {.contour = outline(pear), .points = 0}};
  for (const ShapeRequest &request : requests) {
    const Shape shape = make_shape(request);
    const Solid points = solid(shape, 2.0);
    EXPECT_NEAR(points.mass, pi, 1e-12);
    EXPECT_NEAR(points.centre.norm(), 0.0, 1e-12);
    EXPECT_NEAR(shape.centre_of_mass.norm(), 0.0, 1e-12);
    EXPECT_NEAR(points.inertia, pi * 4 * request.contour->mean_square_radius(), 1e-12);
    for (const auto &point : shape.ring) EXPECT_GT(point.weight, 0.05);
  }
  EXPECT_NEAR(ellipse(0.3, 0.1)->mean_square_radius() * 0.03, (0.15 * 0.15 + 0.05 * 0.05) / 4, 1e-15);
}

TEST(Shapes, FromAFileAreTheirOwnSizeWhereverTheyAre)
{
  Polygon far = pear;
  for (Vector2 &x : far) x = 10.0 * x + Vector2(1e6, -2e6);
  Polygon clockwise(far.rbegin(), far.rend());
  const Contour contour = Contour::polygon(pear), moved = Contour::polygon(far), reversed = Contour::polygon(clockwise);
  EXPECT_NEAR(contour.own_diameter(), std::sqrt(4 * outline_shape(pear).area / pi), 1e-14);
  EXPECT_NEAR(moved.own_diameter(), 10 * contour.own_diameter(), 1e-9);
  const Polygon own = contour.points(0, PointSpacing::arc), own_reversed = reversed.points(0, PointSpacing::arc);
  EXPECT_NEAR(outline_shape(own).area, pi / 4, 1e-14);
  EXPECT_NEAR(outline_shape(own).centroid.norm(), 0.0, 1e-14);
  EXPECT_GT(outline_shape(own_reversed).area, 0.0);
  EXPECT_NEAR((own_reversed[0] - own.back()).norm(), 0.0, 1e-9) << "the file's first vertex stays first";
}

TEST(Shapes, PointsOfAFileAreAtEqualDistancesFromItsFirstVertexOn)
{
  const auto square = outline({{0, 0}, {4, 0}, {4, 4}, {0, 4}});
  const Polygon points = square->points(16, PointSpacing::arc);
  const double side = std::sqrt(pi) / 2;
  EXPECT_NEAR((points[0] - Vector2(-side / 2, -side / 2)).norm(), 0.0, 1e-14);
  EXPECT_NEAR((points[5] - Vector2(side / 2, -side / 4)).norm(), 0.0, 1e-14);
  for (int k = 0; k < 16; ++k) EXPECT_NEAR((points[(k + 1) % 16] - points[k]).norm(), side / 4, 1e-14);
  EXPECT_NEAR((square->points(8, PointSpacing::angle)[1] - Vector2(side / 2, side / 2)).norm(), 0.0, 1e-12) << "a ray through a corner";
  EXPECT_NEAR((square->points(8, PointSpacing::angle)[4] - Vector2(-side / 2, 0)).norm(), 0.0, 1e-12);
}

TEST(Shapes, SpheresReachAsFarAsTheyAreTold)
{
  for (const auto &contour : {ellipse(0.3, 0.15), outline(star(5, 0.6)), outline(pear)})
    for (double reach : {0.0, 0.03}) {
      const Shape shape = make_shape({.contour = contour, .points = 40, .cds = 0.06, .reach = reach});
      for (std::size_t k = 0; k < shape.ring.size(); ++k) {
        const auto &point = shape.ring[k];
        EXPECT_NEAR(0.06 - contour->distance(point.x), reach, 2e-8) << "beyond the outline";
        EXPECT_NEAR((outline_point(point.x, point.outline_offset) - shape.outline[k]).norm(), 0.0, 1e-14);
        EXPECT_GE(point.outline_offset, 0.06 - reach - 1e-12) << "no less than straight inwards";
      }
    }
}

TEST(Shapes, SomePointsMayBeWithoutASphere)
{
  const Shape shape = make_shape({.contour = disk(), .points = 24, .cds_points = 8, .hub_cds = false});
  for (int k = 0; k < 24; ++k) EXPECT_EQ(shape.ring[k].has_cds, k % 3 == 0);
  EXPECT_FALSE(shape.hub_has_cds);
  EXPECT_TRUE(make_shape({.contour = disk()}).hub_has_cds);
}

TEST(Shapes, WithoutSpokesTheHubIsTheRingsMeanAndBearsNoMass)
{
  for (const auto &contour : {disk(), outline(bay), outline(pear)})
    for (const auto share : {MassShare::hub_half, MassShare::equal}) {
      const Shape shape = make_shape({.contour = contour, .points = 32, .spokes = false, .share = share});
      EXPECT_NEAR(shape.hub_mass(1.0), 1e-9, 1e-20);
      Vector2 mean = Vector2::Zero();
      for (const auto &point : shape.ring) mean += point.x / 32;
      EXPECT_NEAR((shape.hub - mean).norm(), 0.0, 1e-15);
      EXPECT_FALSE(shape.hub_has_cds);
      const Solid points = solid(shape, 1.0);
      EXPECT_NEAR(points.mass, pi / 4, 1e-14);
      EXPECT_NEAR((points.centre - shape.centre_of_mass).norm(), 0.0, 1e-14);
      if (share == MassShare::hub_half) {
        EXPECT_LT(points.centre.norm(), 1e-9) << "the centroid of the area";
      }
    }
}

TEST(Shapes, SayWhatIsWrong)
{
  expect_all(complaint({.contour = outline(bay), .points = 32}), {"spokes must stay inside", "does not see", "'spokes no'"});
  expect_all(complaint({.contour = outline(bay), .points = 32, .spacing = PointSpacing::angle, .spokes = false}),
             {"equal angles", "leaves once", "times", "'point_spacing arc'"});
  expect_all(complaint({.contour = disk(), .cds = 0.2, .reach = 0.0}), {"moment of inertia", "so far inside", "raise 'reach'", "'mass equal'"});
  EXPECT_EQ(complaint({.contour = disk(), .cds = 0.2, .reach = 0.0, .share = MassShare::equal}), "no error");
  expect_all(complaint({.contour = disk(), .cds = 0.5, .reach = 0.0}), {"must fit between outline and hub", "lower 'cds'"});
  expect_all(complaint({.contour = ellipse(4, 1), .cds = 0.3, .reach = 0.0}), {"must fit between outline and hub"});
  expect_all(complaint({.contour = disk(), .spokes = false, .cds = 0.1, .reach = 0.05}), {"inside the outline need spokes", "'spokes no'", "leave 'reach' out"});
  expect_all(complaint({.contour = ellipse(1e6, 1), .cds = 1e-3}), {"at most 15 diameters", "farther", "less slender"});
  expect_all(complaint({.contour = outline({{0, 0}, {1, 0}, {1, 1}, {0.5, 1e9}, {0, 1}}), .spokes = false}), {"at most 15 diameters", "less slender"});
  expect_all(complaint({.contour = disk(), .points = 20, .cds_points = 8}), {"'cds_points' must divide", "20", "8", "change"});
  expect_all(complaint({.contour = outline(pear), .points = 2}), {"'points' must be 0", "at least 3", "2"});
  const Polygon thin_bay = {{-2, -2}, {2, -2}, {2, -1.9}, {-1.9, -1.9}, {-1.9, 1.9}, {2, 1.9}, {2, 2}, {-2, 2}};
  expect_all(complaint({.contour = outline(thin_bay), .points = 7, .spokes = false}), {"must not cross itself", "more 'points'"});
}

TEST(Sizes, HaveTheMeanAndSpreadThatWereAskedFor)
{
  const struct { int kind; double spread; } cases[] = {{SizeDistribution::normal, 0.3}, {SizeDistribution::lognormal, 0.5}, {SizeDistribution::uniform, 0.5}};
  for (const auto &one : cases) {
    const SizeDistribution sizes{.kind = one.kind, .spread = one.spread, .seed = 42};
    double sum = 0.0, squares = 0.0, smallest = 1.0;
    constexpr int n = 200000;
    for (int k = 0; k < n; ++k) {
      const double factor = sizes.factor(k);
      sum += factor, squares += factor * factor, smallest = std::min(smallest, factor);
    }
    const double mean = sum / n, deviation = std::sqrt(squares / n - mean * mean);
    EXPECT_NEAR(mean, 1.0, 5 * one.spread / std::sqrt(n)) << one.kind;
    EXPECT_NEAR(deviation, one.spread, 0.01 * one.spread) << one.kind;
    EXPECT_GT(smallest, 0.05) << one.kind;
  }
}

TEST(Sizes, DependOnSeedAndNumberOnly)
{
  const SizeDistribution sizes{.kind = SizeDistribution::normal, .spread = 0.2, .seed = 7}, others{.kind = SizeDistribution::normal, .spread = 0.2, .seed = 8};
  EXPECT_EQ(sizes.factor(3), sizes.factor(3));
  EXPECT_NE(sizes.factor(3), sizes.factor(4));
  EXPECT_NE(sizes.factor(3), others.factor(3));
  EXPECT_EQ(SizeDistribution{}.factor(3), 1.0);
}
