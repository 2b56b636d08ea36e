// The direct solver against the discrete operator itself: what it returns must satisfy a x - c L x = b in every cell.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "fluid/direct_solver.h"
#include "fluid/halo.h"

using namespace swellflow;

namespace {

template <int Dim> std::array<int, Dim> cells();
template <> std::array<int, 2> cells<2>() { return {17, 23}; }
template <> std::array<int, 3> cells<3>() { return {6, 5, 11}; }

// A number that depends on the cell of the whole grid alone, so that it is the same on every number of ranks.
template <int Dim> double noise(const std::array<int, Dim> &cell)
{
  double s = 1.0;
  for (int d = 0; d < Dim; ++d) s += (12.9898 + 65.33 * d) * cell[d];
  return std::sin(s * 43.7);
}

template <int Dim> class Problem {
public:
  Problem(std::array<End, Dim> ends, double a, double c)
      : ends_(ends), a_(a), c_(c), grid_(cells<Dim>(), {}, 0.1, MPI_COMM_WORLD), layout_(grid_), halo_(grid_, layout_), x_(layout_),
        solver_(grid_, layout_, ends)
  {
    solver_.set_operator(a, c);
  }

  template <class F> void each_cell(F &&f)
  {
    std::array<int, Dim> i{};
    const std::function<void(int)> loop = [&](int d) {
      for (i[d] = 0; i[d] < layout_.cells(d); ++i[d]) d ? loop(d - 1) : f(i);
    };
    loop(Dim - 1);
  }

  double value(std::array<int, Dim> i) const
  {
    double sign = 1.0;
    for (int d = 0; d < Dim; ++d) {
      const int at = d == Dim - 1 ? i[d] + grid_.first_plane : i[d];
      if (at >= 0 && at < grid_.cells[d]) continue;
      i[d] += at < 0 ? 1 : -1;
      if (ends_[d] == End::value) sign = -sign;
    }
    return sign * x_[layout_.at(i)];
  }

  double right_hand_side(std::array<int, Dim> i) const
  {
    i[Dim - 1] += grid_.first_plane;
    return noise<Dim>(i);
  }

  double mean_of_right_hand_side()
  {
    double sum[2] = {0.0, 0.0};
    each_cell([&](auto &i) { sum[0] += right_hand_side(i), sum[1] += 1.0; });
    MPI_Allreduce(MPI_IN_PLACE, sum, 2, MPI_DOUBLE, MPI_SUM, grid_.comm);
    return sum[0] / sum[1];
  }

  double largest_residual()
  {
    solver_.solve(
        x_,
        [&](int k) {
          each_cell([&](auto &i) {
            if (i[Dim - 1] == k) x_[layout_.at(i)] = right_hand_side(i);
          });
        },
        [](int) {});
    halo_.fill(x_, 1);
    const bool singular = a_ == 0.0 && std::count(ends_.begin(), ends_.end(), End::gradient) == Dim;
    const double mean = singular ? mean_of_right_hand_side() : 0.0;
    double largest = 0.0;
    each_cell([&](auto &i) {
      double laplacian = 0.0;
      for (int d = 0; d < Dim; ++d)
        for (int step : {-1, 1}) {
          auto j = i;
          j[d] += step;
          laplacian += value(j) - value(i);
        }
      laplacian /= grid_.h * grid_.h;
      largest = std::max(largest, std::abs(a_ * value(i) - c_ * laplacian - right_hand_side(i) + mean));
    });
    MPI_Allreduce(MPI_IN_PLACE, &largest, 1, MPI_DOUBLE, MPI_MAX, grid_.comm);
    return largest;
  }

private:
  std::array<End, Dim> ends_;
  double a_, c_;
  Grid<Dim> grid_;
  Layout<Dim> layout_;
  Halo<Dim> halo_;
  Field<Dim> x_;
  DirectSolver<Dim> solver_;
};

template <int Dim> std::array<End, Dim> all(End end)
{
  std::array<End, Dim> ends;
  ends.fill(end);
  return ends;
}

TEST(DirectSolver, HelmholtzBetweenNoSlipWalls)
{
  for (double c : {1e-6, 1e-3, 1.0, 1e3}) EXPECT_LT(Problem<2>(all<2>(End::value), 1.0, c).largest_residual(), 1e-12 * (1.0 + c * 1e2)) << c;
}

TEST(DirectSolver, PoissonWithFreeMean) { EXPECT_LT(Problem<2>(all<2>(End::gradient), 0.0, -1.0).largest_residual(), 1e-11); }

TEST(DirectSolver, MixedDirections)
{
  EXPECT_LT(Problem<2>({End::value, End::gradient}, 0.3, 2.0).largest_residual(), 1e-11);
  EXPECT_LT(Problem<2>({End::gradient, End::value}, 0.0, 2.0).largest_residual(), 1e-11);
}

TEST(DirectSolver, ThreeDimensionsAreAnInstantiation)
{
  EXPECT_LT(Problem<3>(all<3>(End::value), 1.0, 0.5).largest_residual(), 1e-11);
  EXPECT_LT(Problem<3>(all<3>(End::gradient), 0.0, -1.0).largest_residual(), 1e-11);
}

TEST(Grid, EveryPlaneHasOneOwner)
{
  Grid<2> grid({4, 23}, {}, 1.0, MPI_COMM_WORLD);
  for (int k = 0; k < 23; ++k) {
    const int owner = grid.rank_of_plane(k);
    EXPECT_GE(k, grid.first_plane_of(owner));
    EXPECT_LT(k, grid.first_plane_of(owner + 1));
  }
}

TEST(Grid, RefusesSlabsThinnerThanTheirGhosts)
{
  int ranks = 1;
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  EXPECT_THROW(Grid<2>({4, 2 * ranks - 1}, {}, 1.0, MPI_COMM_WORLD), std::invalid_argument);
}

}  // namespace
