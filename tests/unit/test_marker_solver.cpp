// The impulses that give the fluid the wanted velocities at the markers: what is left of them, and that it holds for all gaps, at walls, periods and ranks.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "fluid/marker_solver.h"

using namespace swellflow;

namespace {

constexpr double h = 0.1, density = 3.0;

using Vecs = std::vector<Vec<2>>;

/// A circle of markers, each rank with those in its slab, and the solver for them.
struct Circle {
  static constexpr double radius = 6.3 * h;

  Grid<2> grid;
  Layout<2> layout{grid};
  std::unique_ptr<Markers<2>> markers;
  MarkerSolver<2> solver;
  std::vector<double> angle, spacing;
  std::vector<int> number;  // of each marker in the whole circle
  int count;

  Circle(const std::string &kernel, double gap, Vec<2> centre = {2.03, 1.97}, bool periodic = false, MPI_Comm comm = MPI_COMM_WORLD)
      : grid({40, 40}, {0.0, 0.0}, h, comm, {periodic, periodic}), markers(make_markers<2>(kernel, grid, layout)), solver(grid, layout, *markers),
        count(static_cast<int>(std::lround(2.0 * std::numbers::pi * radius / (gap * h))))
  {
    Vecs x;
    for (int l = 0; l < count; ++l) {
      const double a = 2.0 * std::numbers::pi * l / count;
      const Vec<2> here{centre[0] + radius * std::cos(a), centre[1] + radius * std::sin(a)};
      int plane = static_cast<int>(std::floor(here[1] / h));
      plane = periodic ? (plane + 40) % 40 : std::clamp(plane, 0, 39);
      if (grid.rank_of_plane(plane) != grid.rank) continue;
      x.push_back(here);
      angle.push_back(a);
      number.push_back(l);
    }
    spacing.assign(x.size(), 2.0 * std::numbers::pi * radius / count);
    markers->place(x);
  }

  /// What is interpolated after spreading.
  Vecs returned(const Vecs &impulses) const
  {
    FaceForcing<2> forcing(grid, layout);
    markers->spread(impulses, density, forcing);
    forcing.complete();
    Vecs u;
    markers->interpolate(forcing.field(), u);
    return u;
  }

  Vecs solve(const Vecs &change)
  {
    Vecs impulses;
    solver.solve(spacing, change, density, impulses);
    return impulses;
  }

  Vecs translation() const { return Vecs(angle.size(), Vec<2>{1.0, -0.5}); }
  /// Translation, rotation and swelling at once.
  Vecs motion() const
  {
    Vecs w;
    for (double a : angle) w.push_back({1.0 - 0.7 * std::sin(a) + 0.3 * std::cos(a), 0.5 + 0.7 * std::cos(a) + 0.3 * std::sin(a)});
    return w;
  }
  Vecs smooth_impulses() const
  {
    Vecs impulses;
    for (std::size_t l = 0; l < angle.size(); ++l)
      impulses.push_back({density * h * spacing[l] * std::cos(3.0 * angle[l]), density * h * spacing[l] * (1.0 + std::sin(2.0 * angle[l]))});
    return impulses;
  }

  double over_ranks(double value, MPI_Op op) const
  {
    MPI_Allreduce(MPI_IN_PLACE, &value, 1, MPI_DOUBLE, op, grid.comm);
    return value;
  }
  double largest(const Vecs &a) const { return largest_difference(a, Vecs(a.size(), Vec<2>{})); }
  double largest_difference(const Vecs &a, const Vecs &b) const
  {
    double result = 0.0;
    for (std::size_t l = 0; l < a.size(); ++l)
      for (int c = 0; c < 2; ++c) result = std::max(result, std::abs(a[l][c] - b[l][c]));
    return over_ranks(result, MPI_MAX);
  }
  /// Largest slip after spreading over the largest velocity asked for.
  double slip(const Vecs &change) { return largest_difference(returned(solve(change)), change) / largest(change); }
};

class MarkerSolvers : public testing::TestWithParam<const char *> {};
INSTANTIATE_TEST_SUITE_P(Kernels, MarkerSolvers, testing::Values("roma_1999", "peskin_2002", "yang_2009"));

TEST_P(MarkerSolvers, LeaveNoSlipWhereSmoothImpulsesCanGiveIt)
{
  for (double gap : {0.25, 0.5, 1.0, 2.0, 3.0}) {
    Circle circle(GetParam(), gap);
    EXPECT_LT(circle.slip(circle.returned(circle.smooth_impulses())), 3e-4) << gap;
  }
}

/// On markers that are denser than cells such velocities would take alternating impulses: what these would give is left as slip.
TEST_P(MarkerSolvers, LeaveLittleSlipOfAMovingCircle)
{
  for (double gap : {0.25, 0.5}) {
    Circle circle(GetParam(), gap);
    EXPECT_LT(circle.slip(circle.motion()), 2e-2) << gap;
  }
  for (double gap : {1.0, 2.0, 3.0}) {
    Circle circle(GetParam(), gap);
    EXPECT_LT(circle.slip(circle.motion()), gap > 1.0 ? 5e-4 : 2e-3) << gap;
    EXPECT_LT(circle.solver.iterations(), 150) << gap;
  }
}

TEST_P(MarkerSolvers, DoNotAlternateOnDenseMarkers)
{
  Circle dense(GetParam(), 0.25), coarse(GetParam(), 1.0);
  const auto sum = [](const Circle &circle, const Vecs &impulses) {
    double total = 0.0;
    for (const auto &j : impulses) total += j[0];
    return circle.over_ranks(total, MPI_SUM);
  };
  Vecs of_dense = dense.solve(dense.translation()), of_coarse = coarse.solve(coarse.translation());
  EXPECT_NEAR(sum(dense, of_dense), sum(coarse, of_coarse), 0.02 * sum(coarse, of_coarse));
  // Per length of outline. Alternating impulses would be many times larger than those of a coarser outline.
  const double ratio = dense.largest(of_dense) * dense.count / (coarse.largest(of_coarse) * coarse.count);
  EXPECT_LT(ratio, 2.5);
}

/// Spacings from nothing to three cells side by side, and one component of which nothing is asked.
TEST_P(MarkerSolvers, WorkOnUnevenMarkers)
{
  Circle circle(GetParam(), 0.7);
  Vecs change;
  double length = 0.0, total = 0.0;
  for (std::size_t l = 0; l < circle.spacing.size(); ++l) {
    circle.spacing[l] *= circle.number[l] % 7 == 0 ? 0.0 : circle.number[l] % 7 == 1 ? 4.0 : 0.6;
    change.push_back({1.0, 0.0});
    length += circle.spacing[l];
  }
  const Vecs impulses = circle.solve(change);
  const Vecs u = circle.returned(impulses);
  for (std::size_t l = 0; l < impulses.size(); ++l) {
    EXPECT_EQ(impulses[l][1], 0.0);
    if (circle.spacing[l] == 0.0)
      EXPECT_EQ(impulses[l][0], 0.0);
    else
      EXPECT_NEAR(u[l][0], 1.0, 2e-2);
    total += impulses[l][0];
  }
  EXPECT_LT(circle.solver.iterations(), 200);
  // Not far from what an even outline takes: density * h * length / scale, or somewhat more.
  const double mean = circle.over_ranks(total, MPI_SUM) / (density * h * circle.over_ranks(length, MPI_SUM)) * circle.markers->scale();
  EXPECT_GT(mean, 0.8);
  EXPECT_LT(mean, 1.2);
}

TEST_P(MarkerSolvers, WorkAtWalls)
{
  // Just clear of the wall, half a cell into its corner (markers beyond lie on the walls).
  for (const Vec<2> centre : {Vec<2>{2.03, Circle::radius + 0.05 * h}, Vec<2>{40.0 * h - Circle::radius + 0.5 * h, 40.0 * h - Circle::radius + 0.5 * h}}) {
    Circle circle(GetParam(), 1.0, centre);
    EXPECT_LT(circle.slip(circle.motion()), 5e-3);
    EXPECT_LT(circle.slip(circle.returned(circle.smooth_impulses())), 3e-4);
  }
}

TEST_P(MarkerSolvers, GiveTheSameOnAllNumbersOfRanks)
{
  for (double gap : {0.25, 1.0, 3.0}) {
    Circle circle(GetParam(), gap), alone(GetParam(), gap, {2.03, 1.97}, false, MPI_COMM_SELF);
    const Vecs here = circle.solve(circle.motion()), whole = alone.solve(alone.motion());
    const double size = alone.largest(whole);
    for (std::size_t l = 0; l < here.size(); ++l)
      for (int c = 0; c < 2; ++c) EXPECT_NEAR(here[l][c], whole[circle.number[l]][c], 1e-10 * size) << gap;
  }
}

TEST_P(MarkerSolvers, SeeNoSeam)
{
  Circle corner(GetParam(), 1.0, {0.03, -0.03}, true), middle(GetParam(), 1.0, {2.03, 1.97}, true, MPI_COMM_SELF);
  const Vecs here = corner.solve(corner.motion()), whole = middle.solve(middle.motion());
  const double size = middle.largest(whole);
  for (std::size_t l = 0; l < here.size(); ++l)
    for (int c = 0; c < 2; ++c) EXPECT_NEAR(here[l][c], whole[corner.number[l]][c], 1e-6 * size);  // the kernels' square roots
}

TEST(MarkerSolver, DoesNothingWhereNothingIsAskedFor)
{
  Circle circle("roma_1999", 1.0);
  EXPECT_EQ(circle.largest(circle.solve(Vecs(circle.angle.size(), Vec<2>{}))), 0.0);
  EXPECT_EQ(circle.solver.iterations(), 0);
  const Grid<2> grid({8, 8}, {0.0, 0.0}, h, MPI_COMM_WORLD);
  const Layout<2> layout(grid);
  const auto none = make_markers<2>("roma_1999", grid, layout);
  Vecs impulses(3);
  MarkerSolver<2>(grid, layout, *none).solve({}, {}, density, impulses);
  EXPECT_TRUE(impulses.empty());
}

TEST(MarkerSolver, SaysWhenItDoesNotConverge)
{
  Circle circle("roma_1999", 1.0);
  Vecs impulses, bad = circle.motion();
  const auto message = [&](MarkerSolver<2> &&solver, const Vecs &change) {
    try {
      solver.solve(circle.spacing, change, density, impulses);
    } catch (const std::runtime_error &error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_NE(message({circle.grid, circle.layout, *circle.markers, 3}, bad).find("after 3 iterations"), std::string::npos);
  if (!bad.empty()) bad[0][0] = std::nan("");
  EXPECT_NE(message({circle.grid, circle.layout, *circle.markers}, bad).find("after 0 iterations"), std::string::npos);
}

TEST(MarkerSolver, ServesASphere)
{
  const Grid<3> grid({16, 16, 16}, {0.0, 0.0, 0.0}, h, MPI_COMM_WORLD);
  const Layout<3> layout(grid);
  const auto markers = make_markers<3>("yang_2009", grid, layout);
  MarkerSolver<3> solver(grid, layout, *markers);
  constexpr int count = 180;
  const double radius = 3.8 * h, golden = std::numbers::pi * (3.0 - std::sqrt(5.0));
  std::vector<Vec<3>> x;
  for (int l = 0; l < count; ++l) {
    const double z = 1.0 - (2.0 * l + 1.0) / count, r = std::sqrt(1.0 - z * z);
    const Vec<3> here{0.81 + radius * r * std::cos(l * golden), 0.79 + radius * r * std::sin(l * golden), 0.8 + radius * z};
    if (grid.rank_of_plane(static_cast<int>(here[2] / h)) == grid.rank) x.push_back(here);
  }
  markers->place(x);
  const std::vector<Vec<3>> wanted(x.size(), Vec<3>{1.0, 0.5, -1.0});
  std::vector<Vec<3>> impulses, u;
  solver.solve(std::vector<double>(x.size(), 4.0 * std::numbers::pi * radius * radius / count), wanted, density, impulses);
  FaceForcing<3> forcing(grid, layout);
  markers->spread(impulses, density, forcing);
  forcing.complete();
  markers->interpolate(forcing.field(), u);
  for (std::size_t l = 0; l < u.size(); ++l)
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(u[l][c], wanted[l][c], 2e-3);
}

}  // namespace
