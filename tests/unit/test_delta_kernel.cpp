// Delta kernels: moments, support, symmetry, sum of squares, divergence of what they interpolate.
#include <gtest/gtest.h>

#include <array>
#include <random>
#include <type_traits>

#include "fluid/delta_kernel.h"
#include "fluid/markers.h"

using namespace swellflow;

namespace {

template <class Kernel> std::array<double, Kernel::width> weights(double r)
{
  std::array<double, Kernel::width> w;
  Kernel::weights(r, w.data());
  return w;
}

/// Over all positions of a marker relative to its anchor, both ends included.
template <class Kernel, class F> void each_offset(F &&f)
{
  for (int n = 0; n <= 1000; ++n) f(n * 1e-3 - (Kernel::width % 2 ? 0.5 : 0.0));
}

template <class Kernel> class DeltaKernel : public testing::Test {};
using Kernels = testing::Types<Roma1999, Peskin2002, Yang2009, QuadraticBSpline, CubicBSpline>;
TYPED_TEST_SUITE(DeltaKernel, Kernels);

TYPED_TEST(DeltaKernel, VanishesOutsideItsSupportAndIsEven)
{
  for (double r : {0.0, 1e-9, 0.5, 7.0}) EXPECT_EQ(TypeParam::phi(TypeParam::radius + r), 0.0);
  EXPECT_GT(TypeParam::phi(TypeParam::radius - 0.1), 0.0);
  for (double r = 0.0; r < 2.5; r += 0.013) EXPECT_EQ(TypeParam::phi(r), TypeParam::phi(-r));
}

TYPED_TEST(DeltaKernel, SumsToOneWithoutFirstMoment)
{
  each_offset<TypeParam>([](double r) {
    const auto w = weights<TypeParam>(r);
    double sum = 0.0, moment = 0.0;
    for (int i = 0; i < TypeParam::width; ++i) {
      sum += w[i];
      moment += w[i] * (i - TypeParam::anchor - r);
      EXPECT_NEAR(w[i], TypeParam::phi(r - (i - TypeParam::anchor)), 4e-8) << r;  // a square root near zero
    }
    EXPECT_NEAR(sum, 1.0, 1e-15);
    EXPECT_NEAR(moment, 0.0, 1e-15);
  });
}

template <class Kernel> class WholeKernel : public testing::Test {};
using WholeKernels = testing::Types<Roma1999, Peskin2002, Yang2009>;
TYPED_TEST_SUITE(WholeKernel, WholeKernels);

TYPED_TEST(WholeKernel, ScaleIsTheMeanSumOfSquares)
{
  double mean = 0.0, smallest = 1.0, largest = 0.0;
  for (int n = 0; n < 1000; ++n) {
    double squares = 0.0;
    for (double w : weights<TypeParam>((n + 0.5) * 1e-3 - (TypeParam::width % 2 ? 0.5 : 0.0))) squares += w * w;
    mean += squares / 1000;
    smallest = std::min(smallest, squares);
    largest = std::max(largest, squares);
  }
  EXPECT_NEAR(mean, TypeParam::scale, 1e-7);
  const bool varies = std::is_same_v<TypeParam, Yang2009>;
  EXPECT_NEAR(smallest, varies ? 0.43844 : TypeParam::scale, varies ? 1e-5 : 1e-15);
  EXPECT_NEAR(largest, varies ? 0.45506 : TypeParam::scale, varies ? 1e-5 : 1e-15);
}

TEST(Roma1999, HasItsPeak) { EXPECT_DOUBLE_EQ(Roma1999::phi(0.0), 2.0 / 3.0); }

TEST(Peskin2002, GivesEvenAndOddPointsTheSame)
{
  each_offset<Peskin2002>([](double r) {
    const auto w = weights<Peskin2002>(r);
    EXPECT_NEAR(w[0] + w[2], 0.5, 1e-15);
  });
}

TEST(Gruninger2025, SlopeAlongIsADifferenceOfTheKernelAcross)
{
  constexpr double dr = 1e-4;
  for (double r = -2.5; r < 2.5; r += 0.0173) {
    const double slope = (CubicBSpline::phi(r + dr) - CubicBSpline::phi(r - dr)) / (2 * dr);
    EXPECT_NEAR(slope, QuadraticBSpline::phi(r + 0.5) - QuadraticBSpline::phi(r - 0.5), 1e-8) << r;
  }
}

/// Largest |du/dx + dv/dy| between the faces of a field that has none on them, over its largest gradient (1): that of a stream function which is anything on the corners.
double divergence_between_faces(const char *kernel)
{
  const Grid<2> grid({8, 8}, {0.0, 0.0}, 1.0, MPI_COMM_SELF, {true, true});
  const Layout<2> layout(grid);
  const auto markers = make_markers<2>(kernel, grid, layout);
  VectorField<2> faces(layout);
  const auto stream = [](int i, int j) { return std::sin(1.0 + 3.7 * ((i + 8) % 8) + 1.9 * ((j + 8) % 8)); };
  for (int j = -2; j < 10; ++j)
    for (int i = -2; i < 10; ++i) {
      faces[0][layout.at({i, j})] = stream(i, j + 1) - stream(i, j);
      faces[1][layout.at({i, j})] = stream(i, j) - stream(i + 1, j);
    }
  constexpr double d = 1e-4;
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(1.0, 7.0);
  std::vector<Vec<2>> x, u;
  for (int l = 0; l < 200; ++l) {
    const double a = unit(random), b = unit(random);
    x.insert(x.end(), {{a + d, b}, {a - d, b}, {a, b + d}, {a, b - d}});
  }
  markers->place(x);
  markers->interpolate(faces, u);
  double largest = 0.0;
  for (std::size_t l = 0; l < u.size(); l += 4) largest = std::max(largest, std::abs(u[l][0] - u[l + 1][0] + u[l + 2][1] - u[l + 3][1]) / (2 * d));
  return largest;
}

TEST(CompositeKernel, MakesNoDivergenceBetweenTheFaces)
{
  EXPECT_LT(divergence_between_faces("gruninger_2025"), 1e-6);
  for (const char *kernel : {"roma_1999", "peskin_2002", "yang_2009"}) EXPECT_GT(divergence_between_faces(kernel), 0.02) << kernel;
}

TEST(Yang2009, IsTheKernelOfRomaAveragedOverACell)
{
  for (double r = 0.0; r < 2.1; r += 0.0173) {
    constexpr int points = 20000;
    double mean = 0.0;
    for (int n = 0; n < points; ++n) mean += Roma1999::phi(r - 0.5 + (n + 0.5) / points) / points;
    EXPECT_NEAR(Yang2009::phi(r), mean, 1e-7) << r;
  }
}

}  // namespace
