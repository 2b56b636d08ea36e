// A flow that tests run and measure.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "fluid/flow_solver.h"

namespace swellflow_test {

using namespace swellflow;

/// A flow on a box of nx x ny cells of edge h.
class Flow {
public:
  using Exact = std::function<Vec<2>(double x, double y, double t)>;

  Flow(int nx, int ny, double h, double nu, const Boundaries<2> &boundaries, Advection advection = Advection::central)
      : grid({nx, ny}, {}, h, MPI_COMM_WORLD, boundaries.periodic()), solver(grid, {1.0, nu}, boundaries, advection)
  {
  }

  void start(const Exact &exact)
  {
    each_cell([&](double x, double y, std::ptrdiff_t at) {
      const Vec<2> u = exact(x, y, 0.0);
      for (int c = 0; c < 2; ++c) solver.initial_velocity()[c][at] = u[c];
    });
    solver.start_from_velocity();
  }

  void step(double dt)
  {
    solver.predict_velocity(dt);
    solver.project(dt);
    time += dt;
  }
  void run(double until, double dt)
  {
    const long steps = std::lround((until - time) / dt);
    for (long s = 0; s < steps; ++s) step(dt);
  }

  double error(const Exact &exact)
  {
    double sum = 0.0;
    each_cell([&](double x, double y, std::ptrdiff_t at) {
      const Vec<2> u = exact(x, y, time);
      for (int c = 0; c < 2; ++c) sum += std::pow(solver.velocity()[c][at] - u[c], 2);
    });
    MPI_Allreduce(MPI_IN_PLACE, &sum, 1, MPI_DOUBLE, MPI_SUM, grid.comm);
    return std::sqrt(sum / (grid.cells[0] * grid.cells[1]));
  }

  double difference(const Flow &other)
  {
    double sum = 0.0;
    each_cell([&](double, double, std::ptrdiff_t at) {
      for (int c = 0; c < 2; ++c) sum += std::pow(solver.velocity()[c][at] - other.solver.velocity()[c][at], 2);
    });
    MPI_Allreduce(MPI_IN_PLACE, &sum, 1, MPI_DOUBLE, MPI_SUM, grid.comm);
    return std::sqrt(sum / (grid.cells[0] * grid.cells[1]));
  }

  double largest(const std::function<double(double x, double y, const Vec<2> &u)> &measure)
  {
    double largest = 0.0;
    each_cell([&](double x, double y, std::ptrdiff_t at) {
      largest = std::max(largest, measure(x, y, {solver.velocity()[0][at], solver.velocity()[1][at]}));
    });
    MPI_Allreduce(MPI_IN_PLACE, &largest, 1, MPI_DOUBLE, MPI_MAX, grid.comm);
    return largest;
  }

  Grid<2> grid;
  FlowSolver<2> solver;
  double time = 0.0;

private:
  template <class Visit> void each_cell(Visit &&visit)
  {
    for (int k = 0; k < solver.layout().planes(); ++k)
      for (int i = 0; i < grid.cells[0]; ++i)
        visit((i + 0.5) * grid.h, (k + grid.first_plane + 0.5) * grid.h, solver.layout().row(k, 0) + i);
  }
};

inline Boundaries<2> sides(Boundary xlo, Boundary xhi, Boundary ylo, Boundary yhi)
{
  Boundaries<2> result;
  result.kind = {xlo, xhi, ylo, yhi};
  return result;
}

inline void expect_second_order(double coarse, double fine)
{
  const double order = std::log2(coarse / fine);
  EXPECT_GT(order, 1.8) << coarse << " " << fine;
  EXPECT_LT(order, 2.3) << coarse << " " << fine;
}

}  // namespace swellflow_test
