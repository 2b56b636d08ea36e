// The flow solver against a manufactured solution with no-slip walls, and against the published lid-driven cavity.
#include <numbers>

#include "flow.h"

using namespace swellflow_test;

namespace {

constexpr double pi = std::numbers::pi;

// Streamfunction sin^2(pi x) sin^2(pi y) cos(t) / pi: no slip on the unit square; p = cos(pi x) cos(pi y) sin(t): no normal gradient on it.
struct Manufactured {
  double nu;

  static Vec<2> velocity(double x, double y, double t)
  {
    const double sx = std::sin(pi * x), sy = std::sin(pi * y);
    return {sx * sx * std::sin(2 * pi * y) * std::cos(t), -std::sin(2 * pi * x) * sy * sy * std::cos(t)};
  }

  /// du/dt + u . grad u + grad p - nu lap u
  Vec<2> force(double x, double y, double t) const
  {
    const double sx = std::sin(pi * x), sy = std::sin(pi * y), s2x = std::sin(2 * pi * x), s2y = std::sin(2 * pi * y);
    const double c2x = std::cos(2 * pi * x), c2y = std::cos(2 * pi * y), ct = std::cos(t), st = std::sin(t);
    const double u = sx * sx * s2y * ct, v = -s2x * sy * sy * ct;
    const double ux = pi * s2x * s2y * ct, uy = 2 * pi * sx * sx * c2y * ct;
    const double vx = -2 * pi * c2x * sy * sy * ct, vy = -pi * s2x * s2y * ct;
    const double lap_u = (2 * pi * pi * c2x * s2y - 4 * pi * pi * sx * sx * s2y) * ct;
    const double lap_v = (4 * pi * pi * s2x * sy * sy - 2 * pi * pi * s2x * c2y) * ct;
    return {-sx * sx * s2y * st + u * ux + v * uy - pi * sx * std::cos(pi * y) * st - nu * lap_u,
            s2x * sy * sy * st + u * vx + v * vy - pi * std::cos(pi * x) * sy * st - nu * lap_v};
  }
};

class ManufacturedFlow {
public:
  ManufacturedFlow(int n, double nu) : exact_{nu}, grid_({n, n}, {}, 1.0 / n, MPI_COMM_WORLD), flow_(grid_, {1.0, nu}, {})
  {
    each_cell([&](double x, double y, std::ptrdiff_t at) {
      const Vec<2> u = Manufactured::velocity(x, y, 0.0);
      for (int c = 0; c < 2; ++c) flow_.initial_velocity()[c][at] = u[c];
    });
    flow_.start_from_velocity();
  }

  /// The steps may change in length; their sum is the time reached.
  template <class StepLength> void run(int steps, StepLength &&step_length)
  {
    for (int s = 0; s < steps; ++s) {
      const double dt = step_length(s);
      auto &forcing = flow_.forcing();
      forcing.clear();
      forcing.touch(-2, flow_.layout().planes() + 1);
      for (int k = -2; k < flow_.layout().planes() + 2; ++k)
        for (int i = -2; i < grid_.cells[0] + 2; ++i) {
          const double x = i * grid_.h, y = (k + grid_.first_plane) * grid_.h, half = 0.5 * grid_.h;
          const std::ptrdiff_t at = flow_.layout().row(k, 0) + i;
          forcing.faces(0)[at] = dt * exact_.force(x, y + half, time_ + 0.5 * dt)[0];
          forcing.faces(1)[at] = dt * exact_.force(x + half, y, time_ + 0.5 * dt)[1];
        }
      flow_.predict_velocity(dt);
      flow_.project(dt);
      time_ += dt;
    }
  }

  double velocity_error()
  {
    double sum = 0.0;
    each_cell([&](double x, double y, std::ptrdiff_t at) {
      const Vec<2> u = Manufactured::velocity(x, y, time_);
      for (int c = 0; c < 2; ++c) sum += std::pow(flow_.velocity()[c][at] - u[c], 2);
    });
    MPI_Allreduce(MPI_IN_PLACE, &sum, 1, MPI_DOUBLE, MPI_SUM, grid_.comm);
    return std::sqrt(sum) * grid_.h;
  }
  double divergence() const { return flow_.max_divergence(); }

private:
  template <class Visit> void each_cell(Visit &&visit)
  {
    for (int k = 0; k < flow_.layout().planes(); ++k)
      for (int i = 0; i < grid_.cells[0]; ++i)
        visit((i + 0.5) * grid_.h, (k + grid_.first_plane + 0.5) * grid_.h, flow_.layout().row(k, 0) + i);
  }

  Manufactured exact_;
  Grid<2> grid_;
  FlowSolver<2> flow_;
  double time_ = 0.0;
};

double error_after(int n, int steps, double nu, double change_of_step = 0.0)
{
  ManufacturedFlow flow(n, nu);
  const double dt = 0.5 / steps;
  flow.run(steps, [&](int s) { return dt * (1.0 + change_of_step * (s % 2 ? 1.0 : -1.0)); });
  EXPECT_LT(flow.divergence(), 1e-10);
  return flow.velocity_error();
}

TEST(FlowOrders, SecondOrderInSpace)
{
  for (double nu : {0.05, 0.002}) expect_second_order(error_after(16, 400, nu), error_after(32, 400, nu));
}

TEST(FlowOrders, SecondOrderInSpaceAndTimeTogether)
{
  for (double nu : {0.05, 0.002}) expect_second_order(error_after(32, 16, nu), error_after(64, 32, nu));
}

TEST(FlowOrders, SecondOrderWhenTheStepChanges)
{
  expect_second_order(error_after(32, 16, 0.05, 0.2), error_after(64, 32, 0.05, 0.2));
}

// Smallest u on the vertical centre line, by a parabola through the smallest cell value and its neighbours.
double smallest_centre_velocity(int n, double reynolds, double dt, double t_end)
{
  Grid<2> grid({n, n}, {}, 1.0 / n, MPI_COMM_WORLD);
  Boundaries<2> lid;
  lid.velocity[3] = {1.0, 0.0};
  FlowSolver<2> flow(grid, {1.0, 1.0 / reynolds}, lid);
  for (double t = 0.0; t < t_end; t += dt) {
    flow.predict_velocity(dt);
    flow.project(dt);
  }
  std::vector<double> line(n, 0.0);
  for (int k = 0; k < flow.layout().planes(); ++k) {
    const std::ptrdiff_t at = flow.layout().row(k, 0) + n / 2;
    line[grid.first_plane + k] = 0.5 * (flow.velocity()[0][at] + flow.velocity()[0][at - 1]);
  }
  MPI_Allreduce(MPI_IN_PLACE, line.data(), n, MPI_DOUBLE, MPI_SUM, grid.comm);
  const int k = static_cast<int>(std::min_element(line.begin(), line.end()) - line.begin());
  const double slope = 0.5 * (line[k + 1] - line[k - 1]), curvature = line[k + 1] - 2 * line[k] + line[k - 1];
  return line[k] - 0.5 * slope * slope / curvature;
}

// Re = 10: finite differences with Richardson extrapolation; Re = 100: Botella & Peyret, Comput. Fluids 27 (1998).
TEST(LidDrivenCavity, SmallestCentreVelocity)
{
  EXPECT_NEAR(smallest_centre_velocity(64, 10.0, 0.005, 2.0), -0.2076, 0.005 * 0.2076);
  EXPECT_NEAR(smallest_centre_velocity(96, 100.0, 0.008, 20.0), -0.2140424, 0.005 * 0.2140424);
}

TEST(FlowSolver, RefusesAWallThatMovesAlongItsNormal)
{
  Grid<2> grid({8, 8}, {}, 1.0, MPI_COMM_WORLD);
  Boundaries<2> lifting;
  lifting.velocity[3] = {0.0, 1.0};
  EXPECT_THROW(FlowSolver<2>(grid, {1.0, 1.0}, lifting), std::invalid_argument);
}

}  // namespace
