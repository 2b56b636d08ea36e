// What the swelling laws are made of: polynomials, curves through points, random factors.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "liggghts_plugins/objects/monotone_curve.h"
#include "liggghts_plugins/objects/polynomial.h"
#include "liggghts_plugins/objects/random_factor.h"

using namespace swellflow;

TEST(Polynomial, RootsAreFoundInOrderWithinTheInterval)
{
  // (x - 0.5)(x - 1)(x - 3)(x + 2)
  const std::vector<double> p = {-3.0, 8.5, -4.0, -2.5, 1.0};
  const std::vector<double> all = roots(p, -10.0, 10.0), expected = {-2.0, 0.5, 1.0, 3.0};
  ASSERT_EQ(all.size(), 4u);
  for (int k = 0; k < 4; ++k) EXPECT_NEAR(all[k], expected[k], 1e-12);
  EXPECT_EQ(roots(p, 0.0, 2.0).size(), 2u);
  EXPECT_TRUE(roots(p, 1.5, 2.5).empty());
}

TEST(Polynomial, WithoutSignChangesHasNoRoots)
{
  EXPECT_TRUE(roots({1.0, 0.0, 1.0}, -5.0, 5.0).empty());
  EXPECT_TRUE(roots({0.0, 0.0, 1.0}, -5.0, 5.0).empty()) << "it touches zero only";
  EXPECT_TRUE(roots({2.0}, -5.0, 5.0).empty());
  EXPECT_EQ(derivative({1.0, 2.0, 3.0}), (std::vector<double>{2.0, 6.0}));
}

TEST(MonotoneCurve, MakesNoHillsOfItsOwn)
{
  // Steps that a plain cubic spline overshoots.
  const MonotoneCurve curve({0, 1, 2, 3, 4, 7, 7.5, 9}, {0, 0, 0.01, 5, 5.01, 5.02, 1, 1});
  double before = curve.value(-1.0);
  for (double x = -1.0; x <= 7.0; x += 1e-3) {
    ASSERT_GE(curve.value(x), before - 1e-14) << x;
    before = curve.value(x);
  }
  for (double x = 7.001; x <= 10.0; x += 1e-3) ASSERT_LE(curve.value(x), 5.02) << x;
  EXPECT_EQ(curve.value(100.0), 1.0);
}

TEST(MonotoneCurve, PassesThroughItsPointsWithoutKinks)
{
  const std::vector<double> x = {0, 1, 3, 4, 8}, y = {1, 2, 2.5, 4, 4.5};
  const MonotoneCurve curve(x, y);
  for (std::size_t k = 0; k < x.size(); ++k) EXPECT_DOUBLE_EQ(curve.value(x[k]), y[k]);
  for (std::size_t k = 1; k + 1 < x.size(); ++k) {
    const double h = 1e-6, left = (curve.value(x[k]) - curve.value(x[k] - h)) / h, right = (curve.value(x[k] + h) - curve.value(x[k])) / h;
    EXPECT_NEAR(left, right, 1e-4 * std::abs(left) + 1e-5);
  }
}

TEST(MonotoneCurve, IsExactForALineAndOfSecondOrderOrBetterForASmoothCurve)
{
  EXPECT_DOUBLE_EQ(MonotoneCurve({0, 1, 5}, {1, 3, 11}).value(2.7), 6.4);
  const auto error = [](int n) {
    std::vector<double> x, y;
    for (int k = 0; k <= n; ++k) {
      x.push_back(3.0 * k / n);
      y.push_back(std::exp(-x.back()));
    }
    const MonotoneCurve curve(x, y);
    double largest = 0.0;
    for (double t = 0.0; t < 3.0; t += 1e-3) largest = std::max(largest, std::abs(curve.value(t) - std::exp(-t)));
    return largest;
  };
  EXPECT_GT(error(10) / error(20), 3.5);
  EXPECT_LT(error(20), 1.5e-4);
}

TEST(RandomFactor, HasTheMeanAndTheSpreadAskedFor)
{
  for (double spread : {0.05, 0.3, 1.0}) {
    const int n = 200000;
    double sum = 0.0, squares = 0.0;
    for (int object = 1; object <= n; ++object) {
      const double factor = lognormal_factor(Purpose::swelling_rate, spread, 7, object);
      ASSERT_GT(factor, 0.0);
      sum += factor;
      squares += factor * factor;
    }
    const double mean = sum / n, deviation = std::sqrt(squares / n - mean * mean);
    EXPECT_NEAR(mean, 1.0, 4.0 * spread / std::sqrt(n));
    EXPECT_NEAR(deviation, spread, 0.03 * spread);
  }
  EXPECT_EQ(lognormal_factor(Purpose::swelling_rate, 0.0, 7, 3), 1.0);
}

TEST(RandomFactor, DependsOnSeedObjectAndPurposeAndNothingElse)
{
  EXPECT_EQ(lognormal_factor(Purpose::swelling_rate, 0.2, 7, 3), lognormal_factor(Purpose::swelling_rate, 0.2, 7, 3));
  const int n = 20000;
  const auto correlation = [&](auto other) {
    double sum = 0.0;
    for (int object = 1; object <= n; ++object)
      sum += std::log(lognormal_factor(Purpose::swelling_rate, 1.0, 7, object)) * std::log(other(object));
    return sum / n;  // about (ln 2)/4 = 0.12 from the means alone when independent
  };
  const double independent = std::log(2.0) * std::log(2.0) / 4.0, dependent = independent + std::log(2.0), noise = 5.0 * dependent / std::sqrt(n);
  EXPECT_NEAR(correlation([](int object) { return lognormal_factor(Purpose::swelling_rate, 1.0, 7, object); }), dependent, noise) << "the test sees it";
  EXPECT_NEAR(correlation([](int object) { return lognormal_factor(Purpose::swelling_size, 1.0, 7, object); }), independent, noise);
  EXPECT_NEAR(correlation([](int object) { return lognormal_factor(Purpose::swelling_rate, 1.0, 8, object); }), independent, noise);
  EXPECT_NEAR(correlation([](int object) { return lognormal_factor(Purpose::swelling_rate, 1.0, 7, object + 1); }), independent, noise);
}
