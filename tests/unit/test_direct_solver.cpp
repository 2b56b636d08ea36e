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
  Problem(const AllEnds<Dim> &ends, double a, double c)
      : ends_(ends), a_(a), c_(c), grid_(cells<Dim>(), {}, 0.1, MPI_COMM_WORLD, periodic(ends)), layout_(grid_), halo_(grid_, layout_), x_(layout_),
        solver_(std::make_shared<DirectSolver<Dim>>(grid_, layout_, ends)), solve_(layout_, {solver_})
  {
    solver_->set_operator(a, c);
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
      const End end = at < 0 ? ends_[d].lower : ends_[d].upper;
      if (end == End::periodic) {
        if (d < Dim - 1) i[d] += at < 0 ? grid_.cells[d] : -grid_.cells[d];  // across planes the halo has it
        continue;
      }
      i[d] += at < 0 ? 1 : -1;
      if (end == End::value) sign = -sign;
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
    solve_(
        {&x_},
        [&](int k) {
          each_cell([&](auto &i) {
            if (i[Dim - 1] == k) x_[layout_.at(i)] = right_hand_side(i);
          });
        },
        [](int) {});
    halo_.fill(x_, 1);
    const bool singular = a_ == 0.0 && std::none_of(ends_.begin(), ends_.end(), [](const Ends &e) { return e.lower == End::value || e.upper == End::value; });
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
  static std::array<bool, Dim> periodic(const AllEnds<Dim> &ends)
  {
    std::array<bool, Dim> result;
    for (int d = 0; d < Dim; ++d) result[d] = ends[d].periodic();
    return result;
  }

  AllEnds<Dim> ends_;
  double a_, c_;
  Grid<Dim> grid_;
  Layout<Dim> layout_;
  Halo<Dim> halo_;
  Field<Dim> x_;
  std::shared_ptr<DirectSolver<Dim>> solver_;
  JointSolve<Dim, 1> solve_;
};

constexpr Ends value{End::value, End::value}, gradient{End::gradient, End::gradient}, around{End::periodic, End::periodic},
    value_gradient{End::value, End::gradient}, gradient_value{End::gradient, End::value};

template <int Dim> AllEnds<Dim> all(Ends end)
{
  AllEnds<Dim> ends;
  ends.fill(end);
  return ends;
}

TEST(DirectSolver, HelmholtzWithAnyEnds)
{
  for (const Ends &x : {value, gradient, around, value_gradient, gradient_value})
    for (const Ends &y : {value, gradient, around, value_gradient, gradient_value})
      for (double c : {1e-6, 1e-3, 1.0, 1e3}) EXPECT_LT((Problem<2>({x, y}, 1.0, c).largest_residual()), 1e-12 * (1.0 + c * 1e2)) << c << " ends " << int(x.lower) << int(x.upper) << int(y.lower) << int(y.upper);
}

TEST(DirectSolver, PoissonWithAnyEnds)
{
  for (const Ends &x : {value, gradient, around, value_gradient, gradient_value})
    for (const Ends &y : {value, gradient, around, value_gradient, gradient_value})
      EXPECT_LT((Problem<2>({x, y}, 0.0, -1.0).largest_residual()), 1e-11) << "ends " << int(x.lower) << int(x.upper) << int(y.lower) << int(y.upper);
}

TEST(DirectSolver, ThreeDimensionsAreAnInstantiation)
{
  for (const Ends &x : {value, gradient, around, value_gradient})
    for (const Ends &y : {value, gradient, around, gradient_value})
      for (const Ends &z : {value, gradient, around}) {
        EXPECT_LT((Problem<3>({x, y, z}, 1.0, 0.5).largest_residual()), 1e-11);
        EXPECT_LT((Problem<3>({x, y, z}, 0.0, -1.0).largest_residual()), 1e-11);
      }
}

// Unknowns that are solved together, whether they share a solver or not, are solved as if alone.
TEST(DirectSolver, JointSolvesDoNotMix)
{
  const Grid<2> grid({16, 24}, {}, 0.1, MPI_COMM_WORLD);
  const Layout<2> layout(grid);
  const auto shared = std::make_shared<DirectSolver<2>>(grid, layout, all<2>(value));
  const auto other = std::make_shared<DirectSolver<2>>(grid, layout, AllEnds<2>{gradient, value_gradient});
  for (const auto &second : {shared, other}) {
    for (const auto &solver : {shared, second}) solver->set_operator(1.0, 0.1);
    VectorField<2> together(layout);
    Field<2> alone(layout);
    const auto fill = [&](Field<2> &x, int c, int k) {
      for (int i = 0; i < 16; ++i) x[layout.at({i, k})] = noise<2>({i + 100 * c, k + grid.first_plane});
    };
    JointSolve<2, 2>(layout, {shared, second})(
        {&together[0], &together[1]}, [&](int k) { fill(together[0], 0, k), fill(together[1], 1, k); }, [](int) {});
    for (int c = 0; c < 2; ++c) {
      JointSolve<2, 1>(layout, {c ? second : shared})({&alone}, [&](int k) { fill(alone, c, k); }, [](int) {});
      for (int k = 0; k < layout.planes(); ++k)
        for (int i = 0; i < 16; ++i) EXPECT_NEAR(together[c][layout.at({i, k})], alone[layout.at({i, k})], 1e-14);
    }
  }
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
