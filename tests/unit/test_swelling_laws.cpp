// The laws by which objects grow and shrink, and their clock.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "liggghts_plugins/objects/swelling_laws.h"

using namespace swellflow;
using std::numbers::pi;

TEST(LinearSwelling, ReachesItsCeilingExactlyAndStays)
{
  const LinearSwelling law(6e-4, 0.18);
  EXPECT_EQ(law.diameter(0.12, 0.0), 0.12);
  EXPECT_NEAR(law.diameter(0.12, 50.0), 0.15, 1e-15);
  EXPECT_FALSE(law.settled(0.12, 50.0));
  EXPECT_EQ(law.diameter(0.12, 100.1), 0.18);
  EXPECT_TRUE(law.settled(0.12, 100.1));
  EXPECT_EQ(law.diameter(0.12, 1e9), 0.18);
  const double lambda = law.diameter(0.12, 110.0) / 0.12;
  EXPECT_NEAR(lambda * 0.12, 0.18, 1e-16 * 2);
}

TEST(LinearSwelling, ShrinksToItsFloor)
{
  const LinearSwelling law(-6e-4, 0.05);
  EXPECT_EQ(law.diameter(0.12, 0.0), 0.12);
  EXPECT_NEAR(law.diameter(0.12, 100.0), 0.06, 1e-15);
  EXPECT_EQ(law.diameter(0.12, 117.0), 0.05);
  EXPECT_TRUE(law.settled(0.12, 117.0));
  EXPECT_EQ(law.smallest_start(), 0.05);
}

TEST(PolynomialSwelling, IsTheSumOfPowersAndStaysAtItsEnd)
{
  const PolynomialSwelling law(SizeKind::diameter, {0.12, 1e-3, -2e-6, 3e-9}, 200.0);
  const auto D = [](double t) { return 0.12 + 1e-3 * t - 2e-6 * t * t + 3e-9 * t * t * t; };
  for (double t : {0.0, 1.0, 77.7, 200.0}) EXPECT_NEAR(law.diameter(0.5, t), D(t), 1e-15);
  EXPECT_EQ(law.diameter(0.5, 300.0), law.diameter(0.5, 200.0));
  EXPECT_FALSE(law.settled(0.5, 199.0));
  EXPECT_TRUE(law.settled(0.5, 200.0));
}

TEST(PolynomialSwelling, AsARatioIsThatOfTheStart)
{
  const PolynomialSwelling law(SizeKind::ratio, {1.0, 0.01}, 50.0);
  EXPECT_DOUBLE_EQ(law.diameter(0.2, 0.0), 0.2);
  EXPECT_DOUBLE_EQ(law.diameter(0.2, 25.0), 0.25);
  EXPECT_DOUBLE_EQ(law.diameter(0.4, 1e6), 0.6);
}

TEST(PolynomialSwelling, SmallestSizeIsThatOfTheDipBetweenTheEnds)
{
  const PolynomialSwelling law(SizeKind::diameter, {1.0, -2.0, 1.25}, 2.0);  // least at t = 0.8: 0.2
  const SmallestSize dip = smallest_size(law, 1.0, 0.0, 5.0);
  EXPECT_NEAR(dip.elapsed, 0.8, 1e-7);
  EXPECT_NEAR(dip.diameter, 0.2, 1e-14);
  EXPECT_NEAR(smallest_size(law, 1.0, 0.0, 0.5).diameter, 0.3125, 1e-14) << "the dip comes later";
  EXPECT_NEAR(smallest_size(law, 1.0, 1.0, 2.0).elapsed, 1.0, 0.0) << "the dip came before";
  EXPECT_TRUE(std::isnan(smallest_size(PolynomialSwelling(SizeKind::diameter, {1.0, 1e300, 1e300}, 1e200), 1.0, 0.0, 1e200).diameter));
}

/// Diameters in mm of eq. (6) of Guinea, Toriu & Ushijima (2022), with the printed coefficients and with the reconstructed ones, in rational arithmetic.
struct HydrogelRow { double seconds, printed, reconstructed; };
constexpr HydrogelRow hydrogel_rows[] = {{0, 2.9800000, 2.9776400}, {1800, 6.0378352, 5.7960080}, {3600, 8.2146474, 7.7357441}, {7200, 10.8760888, 9.9339669},
                                         {14400, 13.2754644, 11.4813539}, {21600, 14.7331029, 12.2590859}, {28800, 15.9194088, 13.0531864}, {34920, 16.3604859, 13.5038701}};

TEST(HydrogelSwelling, HasThePublishedDiametersInTheUnitsOfTheScript)
{
  const PolynomialSwelling printed = hydrogel_swelling(HydrogelForm::printed, 1e-3, 1.0);
  const PolynomialSwelling reconstructed = hydrogel_swelling(HydrogelForm::reconstructed, 0.1, 1e6);
  for (const auto &row : hydrogel_rows) {
    EXPECT_NEAR(printed.diameter(1.0, row.seconds), 1e-3 * row.printed, 1e-10) << row.seconds;
    EXPECT_NEAR(reconstructed.diameter(1.0, 1e6 * row.seconds), 0.1 * row.reconstructed, 1e-8) << row.seconds;
  }
  EXPECT_EQ(printed.diameter(1.0, 40000.0), printed.diameter(1.0, 34920.0));
  EXPECT_NEAR(reconstructed.diameter(1.0, 1e6 * 34920), 0.1 * 13.5, 0.1 * 0.05) << "what the paper's text says";
}

TEST(HydrogelSwelling, ReconstructedGrowsAllTheTimeAndRoundsToThePrintedDigits)
{
  const PolynomialSwelling law = hydrogel_swelling(HydrogelForm::reconstructed, 1.0, 1.0);
  for (double t = 60.0; t <= 34920.0; t += 60.0) ASSERT_GT(law.diameter(1.0, t), law.diameter(1.0, t - 60.0)) << t;
  EXPECT_EQ(law.turning_times().size(), 1u) << "only the end";
  // The two forms differ by no more than what the printed digits leave open.
  const PolynomialSwelling printed = hydrogel_swelling(HydrogelForm::printed, 1.0, 1.0);
  const double half[] = {5e-3, 5e-4, 5e-10, 5e-14, 5e-19, 5e-24, 5e-29};
  for (const auto &row : hydrogel_rows) {
    double allowed = 0.0;
    for (int k = 0; k < 7; ++k) allowed += half[k] * std::pow(row.seconds, k);
    EXPECT_LE(std::abs(law.diameter(1.0, row.seconds) - printed.diameter(1.0, row.seconds)), allowed);
  }
}

TEST(TableSwelling, PassesThroughItsPointsAndHoldsBothEnds)
{
  const TableSwelling law(SizeKind::ratio, MonotoneCurve({10.0, 20.0, 40.0}, {1.0, 1.5, 2.0}));
  EXPECT_EQ(law.diameter(0.2, 0.0), 0.2);
  EXPECT_DOUBLE_EQ(law.diameter(0.2, 20.0), 0.3);
  EXPECT_EQ(law.diameter(0.2, 41.0), 0.4);
  EXPECT_FALSE(law.settled(0.2, 39.0));
  EXPECT_TRUE(law.settled(0.2, 40.0));
  EXPECT_EQ(TableSwelling(SizeKind::diameter, MonotoneCurve({0.0, 1.0}, {0.3, 0.4})).diameter(7.0, 0.5), 0.35);
}

/// 1 - (6/pi^2) sum n^-2 exp(-n^2 x) by brute force, for x >= 1e-6.
double fraction_by_the_series(double x)
{
  long double sum = 0.0L;
  for (int n = 10000; n >= 1; --n) sum += std::exp(-static_cast<long double>(n) * n * x) / (static_cast<long double>(n) * n);
  return static_cast<double>(1.0L - 6.0L / (std::numbers::pi_v<long double> * std::numbers::pi_v<long double>) * sum);
}

TEST(TanakaFillmoreSwelling, HasThePublishedFractions)
{
  const std::pair<double, double> published[] = {{0.01, 0.1047}, {0.1, 0.3103}, {0.5, 0.6099}, {1.0, 0.7736}, {2.0, 0.9177}};
  for (const auto &[x, fraction] : published) EXPECT_NEAR(swelling_fraction(x), fraction, 5e-5) << x;
}

TEST(TanakaFillmoreSwelling, IsTheSeriesToRoundOffAtAllTimes)
{
  for (double x : {1e-6, 1e-4, 0.01, 0.3, 0.9, 0.999999, 1.0, 1.000001, 3.0, 10.0, 30.0})
    EXPECT_NEAR(swelling_fraction(x), fraction_by_the_series(x), 1e-15) << x;
  EXPECT_NEAR(swelling_fraction(1e-12), 6e-6 / std::pow(pi, 1.5), 1e-12) << "the square root of time";
  EXPECT_EQ(swelling_fraction(0.0), 0.0);
  EXPECT_EQ(swelling_fraction(40.0), 1.0);
}

TEST(TanakaFillmoreSwelling, GoesFromTheStartToTheEnd)
{
  const double tau = TanakaFillmoreSwelling::tau_of(0.2, 1e-3);
  EXPECT_DOUBLE_EQ(tau, 0.01 / (pi * pi * 1e-3));
  const auto growth = TanakaFillmoreSwelling::with_tau(SizeKind::diameter, 0.2, tau), shrinking = TanakaFillmoreSwelling::with_tau(SizeKind::diameter, 0.05, 2.0);
  EXPECT_EQ(growth.diameter(0.1, 0.0), 0.1);
  EXPECT_NEAR(growth.diameter(0.1, tau), 0.17736, 5e-6);
  EXPECT_EQ(growth.diameter(0.1, 41.0 * tau), 0.2);
  EXPECT_TRUE(growth.settled(0.1, 41.0 * tau));
  EXPECT_NEAR(shrinking.diameter(0.1, 1.0), 0.1 - 0.05 * 0.6099, 5e-6);
}

TEST(TanakaFillmoreSwelling, OfARatioGivesEachObjectItsOwnPace)
{
  const double gel = 1e-3;
  const auto growth = TanakaFillmoreSwelling::with_diffusivity(SizeKind::ratio, 2.0, gel);
  for (const double start : {0.1, 0.3}) {
    const double tau = TanakaFillmoreSwelling::tau_of(2.0 * start, gel);
    EXPECT_DOUBLE_EQ(growth.diameter(start, tau), start * (1.0 + swelling_fraction(1.0)));
    EXPECT_EQ(growth.diameter(start, 41.0 * tau), 2.0 * start);
    EXPECT_FALSE(growth.settled(start, 39.0 * tau));
    EXPECT_TRUE(growth.settled(start, 41.0 * tau));
  }
}

TEST(SwellingClock, CountsOnOverChangesOfTheStep)
{
  SwellingClock clock{.base_time = 0.0, .base_step = 100, .step_length = 0.5};
  EXPECT_EQ(clock.time(110), 5.0);
  clock.change_step_length(110, 0.1);
  EXPECT_EQ(clock.time(110), 5.0);
  EXPECT_DOUBLE_EQ(clock.time(120), 6.0);
  clock.renumber(0, 120);
  EXPECT_DOUBLE_EQ(clock.time(0), 6.0);
  EXPECT_DOUBLE_EQ(clock.time(10), 7.0);
}

TEST(SwellingClock, TwoPartsAreOne)
{
  SwellingClock one{.base_time = 0.0, .base_step = 0, .step_length = 5e-3}, two = one;
  for (long step = 0; step < 22000; step += 777) two.change_step_length(step, 5e-3);
  EXPECT_EQ(one.time(22000), two.time(22000));
}
