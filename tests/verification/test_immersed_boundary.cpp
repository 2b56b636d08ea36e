// Orders of convergence with objects in the fluid: first order in the grid and first order in time, whatever the forcing.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "fluid/flow_solver.h"
#include "fluid/marker_solver.h"

using namespace swellflow;

namespace {

constexpr double pi = std::numbers::pi;

enum class Forcing { direct, implicit };

/// Creeping flow in a unit box around outlines of markers that move as told.
class ImmersedFlow {
public:
  struct Marker {
    Vec<2> x, u;
    double spacing;
  };

  ImmersedFlow(int n, double nu, Forcing forcing, const std::string &kernel = "roma_1999")
      : grid({n, n}, {}, 1.0 / n, MPI_COMM_WORLD), flow(grid, {1.0, nu}, {}, Advection::none), markers(make_markers<2>(kernel, flow.grid(), flow.layout())),
        solver(flow.grid(), flow.layout(), *markers), forcing_(forcing)
  {
  }

  /// As the coupled step: the force of each marker is carried into the next, and changed so that before the projection the fluid at x has the velocity u. Every
  /// rank gets all markers, as many at each step, and serves those in its rows.
  void step(double dt, const std::vector<Marker> &all)
  {
    carried_.resize(all.size());
    std::vector<std::size_t> own;
    std::vector<Vec<2>> places, impulses, velocities;
    std::vector<double> spacing;
    for (std::size_t l = 0; l < all.size(); ++l) {
      if (grid.rank_of_plane(static_cast<int>(all[l].x[1] / grid.h)) != grid.rank) continue;
      own.push_back(l);
      places.push_back(all[l].x);
      spacing.push_back(all[l].spacing);
      impulses.push_back({carried_[l][0] * dt, carried_[l][1] * dt});
    }
    markers->place(places);
    spread(impulses);
    flow.predict_velocity(dt);
    markers->interpolate(flow.face_velocity_around(), velocities);
    for (std::size_t l = 0; l < own.size(); ++l)
      for (int d = 0; d < 2; ++d) velocities[l][d] = all[own[l]].u[d] - velocities[l][d];
    if (forcing_ == Forcing::implicit)
      solver.solve(spacing, velocities, 1.0, impulses);
    else
      for (std::size_t l = 0; l < own.size(); ++l)
        for (int d = 0; d < 2; ++d) impulses[l][d] = velocities[l][d] * spacing[l] * grid.h / markers->scale();
    spread(impulses);
    flow.apply_forcing();
    flow.project(dt);
    share(own, impulses, dt);
  }

  /// Root of the mean of a square over the cells in which it is not negative.
  double root_mean(const std::function<double(double x, double y, const Vec<2> &u)> &square)
  {
    double sums[2] = {};
    for (int k = 0; k < flow.layout().planes(); ++k)
      for (int i = 0; i < grid.cells[0]; ++i) {
        const auto at = flow.layout().row(k, 0) + i;
        const double s = square((i + 0.5) * grid.h, (k + grid.first_plane + 0.5) * grid.h, {flow.velocity()[0][at], flow.velocity()[1][at]});
        if (s < 0.0) continue;
        sums[0] += s;
        sums[1] += 1.0;
      }
    MPI_Allreduce(MPI_IN_PLACE, sums, 2, MPI_DOUBLE, MPI_SUM, grid.comm);
    return std::sqrt(sums[0] / sums[1]);
  }

  double difference(const ImmersedFlow &other)
  {
    const int n = grid.cells[0];
    return root_mean([&](double x, double y, const Vec<2> &u) {
      const auto at = flow.layout().row(static_cast<int>(y * n) - grid.first_plane, 0) + static_cast<int>(x * n);
      return std::pow(u[0] - other.flow.velocity()[0][at], 2) + std::pow(u[1] - other.flow.velocity()[1][at], 2);
    });
  }

  Grid<2> grid;
  FlowSolver<2> flow;
  std::unique_ptr<Markers<2>> markers;
  MarkerSolver<2> solver;

private:
  void spread(const std::vector<Vec<2>> &impulses)
  {
    flow.forcing().clear();
    markers->spread(impulses, 1.0, flow.forcing());
    flow.forcing().complete();
  }
  void share(const std::vector<std::size_t> &own, const std::vector<Vec<2>> &impulses, double dt)
  {
    std::vector<Vec<2>> change(carried_.size(), Vec<2>{});
    for (std::size_t l = 0; l < own.size(); ++l)
      for (int d = 0; d < 2; ++d) change[own[l]][d] = impulses[l][d] / dt;
    MPI_Allreduce(MPI_IN_PLACE, change.data(), 2 * static_cast<int>(change.size()), MPI_DOUBLE, MPI_SUM, grid.comm);
    for (std::size_t l = 0; l < change.size(); ++l)
      for (int d = 0; d < 2; ++d) carried_[l][d] += change[l][d];
  }

  Forcing forcing_;
  std::vector<Vec<2>> carried_;
};

void add_circle(std::vector<ImmersedFlow::Marker> &markers, const Vec<2> &centre, double radius, const Vec<2> &velocity, double spin, double gap)
{
  const int n = static_cast<int>(std::ceil(2 * pi * radius / gap));
  for (int l = 0; l < n; ++l) {
    const double a = 2 * pi * l / n, rx = radius * std::cos(a), ry = radius * std::sin(a);
    markers.push_back({{centre[0] + rx, centre[1] + ry}, {velocity[0] - spin * ry, velocity[1] + spin * rx}, 2 * pi * radius / n});
  }
}

void expect_first_order(double coarse, double fine)
{
  const double order = std::log2(coarse / fine);
  EXPECT_GT(order, 0.85) << coarse << " " << fine;
  EXPECT_LT(order, 1.2) << coarse << " " << fine;
}

// ---- in space --------------------------------------------------------------------------------------------------------------------------------

/// Two circles that turn with w1 and w2 drive a flow u = A r + B / r between them. Its error there, after times in which it becomes steady. The markers sit on the
/// circles themselves: any retraction is of first order, too.
double couette_error(int n, Forcing forcing, double gap, const std::string &kernel = "roma_1999")
{
  constexpr double r1 = 0.2, r2 = 0.4, w1 = -2.0, w2 = 2.5, t_end = 0.1;
  constexpr double b = (w1 - w2) / (1 / (r1 * r1) - 1 / (r2 * r2)), a = w1 - b / (r1 * r1);
  const Vec<2> centre{0.503, 0.498};
  ImmersedFlow fluid(n, 1.0, forcing, kernel);
  const double h = fluid.grid.h;
  std::vector<ImmersedFlow::Marker> circles;
  add_circle(circles, centre, r1, {}, w1, gap * h);
  add_circle(circles, centre, r2, {}, w2, gap * h);
  const int steps = static_cast<int>(std::ceil(t_end / (4.0 * h * h)));
  for (int s = 0; s < steps; ++s) fluid.step(t_end / steps, circles);
  EXPECT_LT(fluid.flow.max_divergence(), 1e-10);
  return fluid.root_mean([&](double x, double y, const Vec<2> &u) {
    const double rx = x - centre[0], ry = y - centre[1], r = std::hypot(rx, ry), w = a + b / (r * r);
    return r < r1 || r > r2 ? -1.0 : std::pow(u[0] + w * ry, 2) + std::pow(u[1] - w * rx, 2);
  });
}

TEST(ImmersedBoundary, CouetteIsOfFirstOrderInTheGrid)
{
  const double coarse = couette_error(32, Forcing::direct, 1.0), middle = couette_error(64, Forcing::direct, 1.0), fine = couette_error(128, Forcing::direct, 1.0);
  expect_first_order(coarse, middle);
  expect_first_order(middle, fine);
  EXPECT_LT(fine, 0.03);  // the outer circle moves at 1
}

// The steady state is that in which no marker's force changes any more: the same for both.
TEST(ImmersedBoundary, ImplicitForcingConvergesToTheSame)
{
  const double coarse = couette_error(32, Forcing::implicit, 1.5), fine = couette_error(64, Forcing::implicit, 1.5);
  expect_first_order(coarse, fine);
  const double direct = couette_error(64, Forcing::direct, 1.5);
  EXPECT_NEAR(fine, direct, 0.01 * fine);
}

TEST(ImmersedBoundary, OtherKernelsAreOfFirstOrder)
{
  for (const char *kernel : {"peskin_2002", "yang_2009", "gruninger_2025"})
    expect_first_order(couette_error(32, Forcing::direct, 1.0, kernel), couette_error(64, Forcing::direct, 1.0, kernel));
}

// ---- in time ---------------------------------------------------------------------------------------------------------------------------------

/// A circle starts gently and goes the way 0.1 sin^2(pi t) for half a period, along x, or its outline about its centre. As in the coupled step the markers are
/// where they are when a step begins, and their velocity is its mean.
class MovingCircle : public ImmersedFlow {
public:
  MovingCircle(int steps, Forcing forcing, bool turns) : ImmersedFlow(32, 0.05, forcing, "yang_2009")
  {
    constexpr double radius = 0.15, gap = 1.5 / 32;
    const double dt = 0.5 / steps;
    const auto way = [](double t) { return 0.1 * std::pow(std::sin(pi * t), 2); };
    for (int s = 0; s < steps; ++s) {
      const double velocity = (way((s + 1) * dt) - way(s * dt)) / dt;
      std::vector<Marker> circle;
      if (turns)
        add_circle(circle, {0.5, 0.5}, radius, {}, velocity / radius, gap);
      else
        add_circle(circle, {0.45 + way(s * dt), 0.5}, radius, {velocity, 0.0}, 0.0, gap);
      step(dt, circle);
    }
  }
};

/// On one grid against smaller steps, so that the error of the time step alone counts. Forces that are carried over from the step before, and markers that are not
/// asked again after the projection, make it of first order.
void expect_first_order_in_time(int steps, Forcing forcing, bool turns)
{
  MovingCircle coarse(steps, forcing, turns), middle(2 * steps, forcing, turns), fine(4 * steps, forcing, turns);
  expect_first_order(coarse.difference(middle), middle.difference(fine));
}

TEST(ImmersedBoundary, ATurningCircleIsOfFirstOrderInTime)
{
  for (const Forcing forcing : {Forcing::direct, Forcing::implicit}) expect_first_order_in_time(64, forcing, true);
}

TEST(ImmersedBoundary, AMovingCircleIsOfFirstOrderInTime) { expect_first_order_in_time(128, Forcing::direct, false); }

}  // namespace
