// Delta kernels: moments, support, symmetry, sum of squares.
#include <gtest/gtest.h>

#include <array>
#include <type_traits>

#include "fluid/delta_kernel.h"

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
using Kernels = testing::Types<Roma1999, Peskin2002, Yang2009>;
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

TYPED_TEST(DeltaKernel, ScaleIsTheMeanSumOfSquares)
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
