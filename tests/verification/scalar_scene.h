// A scalar in a flow that is given, for tests to run and measure.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "fluid/scalar_transport.h"

namespace swellflow_test {

using namespace swellflow;

/// A scalar on a box of nx x ny cells of edge h, in a flow that is given.
class ScalarScene {
public:
  using Function = std::function<double(double x, double y)>;

  ScalarScene(int nx, int ny, double h, std::array<bool, 2> periodic, double diffusivity, const ScalarTransport<2>::Sides &sides)
      : grid({nx, ny}, {}, h, MPI_COMM_WORLD, periodic), layout(grid), faces(layout), scalar(grid, layout, diffusivity, sides)
  {
  }

  void start(const Function &c)
  {
    each_cell([&](double x, double y, std::ptrdiff_t at) { scalar.values()[at] = c(x, y); });
    start_total = total();
  }
  /// The mean normal velocity of each face from a stream function: no divergence, to round-off.
  void flow(const Function &psi)
  {
    const double h = grid.h;
    for (int k = 0; k <= layout.planes(); ++k)
      for (int i = 0; i <= grid.cells[0]; ++i) {
        const double x = i * h, y = (k + grid.first_plane) * h;
        if (k < layout.planes()) faces[0][layout.row(k, 0) + i] = (psi(x, y + h) - psi(x, y)) / h;
        if (i < grid.cells[0]) faces[1][layout.row(k, 0) + i] = (psi(x, y) - psi(x + h, y)) / h;
      }
  }
  void uniform_flow(double u, double v)
  {
    flow([=](double x, double y) { return u * y - v * x; });
  }
  void run(double until, double dt, bool grows = false)
  {
    const long steps = std::lround(until / dt);
    for (long s = 0; s < steps; ++s) scalar.advance(until / steps, faces, grows);
  }

  double error(const Function &exact)
  {
    double sum = 0.0;
    each_cell([&](double x, double y, std::ptrdiff_t at) { sum += std::pow(scalar.values()[at] - exact(x, y), 2); });
    return std::sqrt(over_ranks(sum, MPI_SUM) / (grid.cells[0] * grid.cells[1]));
  }
  /// Root of the mean square.
  double difference(const ScalarScene &other)
  {
    double sum = 0.0;
    each_cell([&](double, double, std::ptrdiff_t at) { sum += std::pow(scalar.values()[at] - other.scalar.values()[at], 2); });
    return std::sqrt(over_ranks(sum, MPI_SUM) / (grid.cells[0] * grid.cells[1]));
  }
  double total() { return over_ranks(scalar.total_here(), MPI_SUM); }
  double entered() { return over_ranks(scalar.budget().entered, MPI_SUM); }
  double left() { return over_ranks(scalar.budget().left, MPI_SUM); }
  double appeared() { return over_ranks(scalar.budget().appeared, MPI_SUM); }
  double withdrawn() { return over_ranks(scalar.budget().withdrawn, MPI_SUM); }
  /// Of what there is over what there was, came and went.
  double imbalance()
  {
    const double in = entered() + appeared(), out = left() + withdrawn();
    return std::abs(total() - (start_total + in - out)) / (std::abs(start_total) + std::abs(in) + std::abs(out));
  }
  void expect_within(double low, double high)
  {
    const auto here = scalar.extremes_here();
    EXPECT_LT(over_ranks(here.largest, MPI_MAX), high + 1e-12);
    EXPECT_GT(over_ranks(here.smallest, MPI_MIN), low - 1e-12);
  }

  template <class Visit> void each_cell(Visit &&visit)
  {
    for (int k = 0; k < layout.planes(); ++k)
      for (int i = 0; i < grid.cells[0]; ++i) visit((i + 0.5) * grid.h, (k + grid.first_plane + 0.5) * grid.h, layout.row(k, 0) + i);
  }
  static double over_ranks(double number, MPI_Op op)
  {
    MPI_Allreduce(MPI_IN_PLACE, &number, 1, MPI_DOUBLE, op, MPI_COMM_WORLD);
    return number;
  }

  Grid<2> grid;
  Layout<2> layout;
  VectorField<2> faces;
  ScalarTransport<2> scalar;
  double start_total = 0.0;
};

}  // namespace swellflow_test
