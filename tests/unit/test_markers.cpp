// Delta kernels and the pair of operators made of them: moments, adjointness, partition of unity up to the walls.
#include <gtest/gtest.h>

#include <numeric>
#include <random>

#include "fluid/markers.h"

using namespace swellflow;

namespace {

TEST(Roma1999, VanishesOutsideItsSupportAndIsEven)
{
  for (double r : {1.5, 1.6, 2.0, 7.0}) EXPECT_EQ(Roma1999::phi(r), 0.0);
  for (double r = 0.0; r < 2.0; r += 0.013) EXPECT_EQ(Roma1999::phi(r), Roma1999::phi(-r));
  EXPECT_DOUBLE_EQ(Roma1999::phi(0.0), 2.0 / 3.0);
}

TEST(Roma1999, MomentsHoldForEveryPosition)
{
  for (double r = -0.5; r <= 0.5; r += 0.01) {
    double w[3];
    Roma1999::weights(r, w);
    EXPECT_NEAR(w[0] + w[1] + w[2], 1.0, 1e-15);
    EXPECT_NEAR(w[2] - w[0], r, 1e-15);                                       // first moment about the middle point
    EXPECT_NEAR(w[0] * w[0] + w[1] * w[1] + w[2] * w[2], 0.5, 1e-15);         // Roma et al., eq. (21)
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(w[i], Roma1999::phi(r - (i - 1)), 2e-8) << r;  // a square root near zero
  }
}

class MarkersOnSlabs : public testing::Test {
protected:
  static constexpr double h = 0.25;
  Grid<2> grid{{20, 24}, {-1.0, 2.0}, h, MPI_COMM_WORLD};
  Layout<2> layout{grid};
  Markers<2> markers{grid, layout};
  FaceForcing<2> forcing{grid, layout};
  VectorField<2> faces{layout};
  std::vector<Vec<2>> positions, values;

  // The same cloud on every number of ranks, walls and corners included; each rank takes what lies in its slab.
  void scatter(int count)
  {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> unit(0.0, 1.0), value(-1.0, 1.0);
    for (int l = 0; l < count; ++l) {
      double a = unit(random), b = unit(random);
      if (l % 5 == 0) a = l % 2;
      if (l % 7 == 0) b = l % 2;
      const Vec<2> x{-1.0 + a * 20 * h, 2.0 + b * 24 * h}, v{value(random), value(random)};
      const int plane = std::min(23, static_cast<int>((x[1] - 2.0) / h));
      if (grid.rank_of_plane(plane) != grid.rank) continue;
      positions.push_back(x);
      values.push_back(v);
    }
    markers.place(positions);
  }

  // Sum over the faces that this rank owns, walls left out: they are given.
  template <class F> Vec<2> sum_over_faces(F &&f) const
  {
    Vec<2> sum{};
    for (int k = 0; k < layout.planes(); ++k)
      for (int i = 0; i < 20; ++i)
        for (int c = 0; c < 2; ++c)
          if (c == 0 ? i > 0 : k + grid.first_plane > 0) sum[c] += f(c, layout.row(k, 0) + i);
    MPI_Allreduce(MPI_IN_PLACE, sum.data(), 2, MPI_DOUBLE, MPI_SUM, grid.comm);
    return sum;
  }
  Vec<2> sum_over_markers(const std::vector<Vec<2>> &a, const std::vector<Vec<2>> &b) const
  {
    Vec<2> sum{};
    for (std::size_t l = 0; l < a.size(); ++l)
      for (int c = 0; c < 2; ++c) sum[c] += a[l][c] * b[l][c];
    MPI_Allreduce(MPI_IN_PLACE, sum.data(), 2, MPI_DOUBLE, MPI_SUM, grid.comm);
    return sum;
  }
};

TEST_F(MarkersOnSlabs, InterpolateAConstantExactlyUpToTheWalls)
{
  scatter(300);
  for (int c = 0; c < 2; ++c) std::fill_n(faces[c].data(), layout.size(), 3.0 + c);
  std::vector<Vec<2>> u;
  markers.interpolate(faces, u);
  for (const auto &v : u)
    for (int c = 0; c < 2; ++c) EXPECT_NEAR(v[c], 3.0 + c, 1e-13);
}

TEST_F(MarkersOnSlabs, GiveTheFluidTheWholeImpulse)
{
  scatter(300);
  const double density = 7.0;
  markers.spread(values, density, forcing);
  forcing.complete();
  const Vec<2> given = sum_over_faces([&](int c, std::ptrdiff_t at) { return density * h * h * forcing.faces(c)[at]; });
  const Vec<2> total = sum_over_markers(values, std::vector<Vec<2>>(values.size(), Vec<2>{1.0, 1.0}));
  for (int c = 0; c < 2; ++c) EXPECT_NEAR(given[c], total[c], 1e-12);
}

TEST_F(MarkersOnSlabs, SpreadingIsTheAdjointOfInterpolation)
{
  scatter(300);
  Halo<2> halo(grid, layout);
  for (int c = 0; c < 2; ++c) {
    for (int k = 0; k < layout.planes(); ++k)
      for (int i = 0; i < 20; ++i) faces[c][layout.row(k, 0) + i] = std::sin(1.0 + i * 0.7 + (k + grid.first_plane) * 1.3 + c);
    halo.fill(faces[c], 2);
  }
  std::vector<Vec<2>> u;
  markers.interpolate(faces, u);
  markers.spread(values, 1.0, forcing);
  forcing.complete();
  const Vec<2> left = sum_over_markers(values, u);
  const Vec<2> right = sum_over_faces([&](int c, std::ptrdiff_t at) { return h * h * forcing.faces(c)[at] * faces[c][at]; });
  for (int c = 0; c < 2; ++c) EXPECT_NEAR(left[c], right[c], 1e-12);
}

TEST_F(MarkersOnSlabs, ClearedForcingIsZeroEverywhere)
{
  scatter(40);
  markers.spread(values, 1.0, forcing);
  forcing.complete();
  forcing.clear();
  for (int c = 0; c < 2; ++c)
    EXPECT_EQ(std::accumulate(forcing.faces(c), forcing.faces(c) + layout.size(), 0.0, [](double s, double f) { return s + std::abs(f); }), 0.0);
}

}  // namespace
