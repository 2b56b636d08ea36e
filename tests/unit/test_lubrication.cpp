// The force in a narrow gap: against an exact solution, the part that is added, and steps of any length.
#include <gtest/gtest.h>

#include <vector>

#include "liggghts_plugins/objects/lubrication.h"

using namespace swellflow;

namespace {

const LubricationLaw law{.viscosity = 2.0, .wall_cutoff = 0.1, .pair_cutoff = 0.06, .minimum = 1e-3};

/// Cylinder of radius 1 that moves towards a plane, Jeffrey & Onishi (1981): 4 pi mu / (alpha - tanh alpha), cosh alpha = 1 + gap.
double jeffrey_onishi(double viscosity, double gap)
{
  const double alpha = std::acosh(1.0 + gap);
  return 4.0 * std::numbers::pi * viscosity / (alpha - std::tanh(alpha));
}

/// Kinetic energies over those at the start of a row of bodies of the masses, each with a gap to the next, after each of ten steps; the first moves towards the second.
std::vector<double> energies(const std::vector<double> &mass, double resistance, double dt)
{
  const std::size_t n = mass.size();
  std::vector<double> v(n, 0.0), result;
  for (std::size_t i = 0; i < n; i++) v[i] = i % 2 == 0 ? 1.0 : -1.0;
  const auto energy = [&] {
    double sum = 0.0;
    for (std::size_t i = 0; i < n; i++) sum += 0.5 * mass[i] * v[i] * v[i];
    return sum;
  };
  const auto share = [&](std::size_t i) { return (i == 0 || i == n - 1 ? 1.0 : 2.0) / mass[i]; };
  for (int step = 0; step <= 10; step++) {
    result.push_back(energy());
    const std::vector<double> before = v;
    for (std::size_t i = 0; i + 1 < n; i++) {
      const double F = implicit_resistance(resistance, dt, share(i), share(i + 1)) * (before[i] - before[i + 1]);
      v[i] -= dt * F / mass[i];
      v[i + 1] += dt * F / mass[i + 1];
    }
  }
  return result;
}

}  // namespace

TEST(Lubrication, IsTheLimitOfTheExactForceAtAWall)
{
  // The exact one is 1 + 1.05 gap / R + … times as large, as its series says.
  for (const double gap : {1e-4, 1e-3, 1e-2}) {
    const double ratio = lubrication_resistance(2.0, 1.0, gap) / jeffrey_onishi(2.0, gap);
    EXPECT_NEAR(ratio, 1.0 - 1.05 * gap, 2.0 * gap * gap);
  }
}

TEST(Lubrication, ScalesWithRadiusAndViscosity)
{
  EXPECT_DOUBLE_EQ(effective_radius(1.0, 1.0), 0.5);
  EXPECT_DOUBLE_EQ(effective_radius(1.0, 3.0), 0.75);
  EXPECT_NEAR(lubrication_resistance(1.0, 0.5, 0.005) / lubrication_resistance(1.0, 1.0, 0.01), 1.0, 1e-14);
  EXPECT_NEAR(lubrication_resistance(3.0, 1.0, 0.01) / lubrication_resistance(1.0, 4.0, 0.01), 3.0 / 8.0, 1e-14);
}

TEST(Lubrication, WhatIsMissingStartsAtTheCutoffAndEndsAtTheMinimum)
{
  EXPECT_EQ(law.missing_at_wall(1.0, 0.1), 0.0);
  EXPECT_EQ(law.missing_at_wall(1.0, 7.0), 0.0);
  EXPECT_NEAR(law.missing_at_wall(1.0, 0.1 - 1e-12), 0.0, 1e-6);
  EXPECT_DOUBLE_EQ(law.missing_at_wall(1.0, 0.01), lubrication_resistance(2.0, 1.0, 0.01) - lubrication_resistance(2.0, 1.0, 0.1));
  EXPECT_EQ(law.missing_between(1.0, 3.0, 0.06), 0.0);
  EXPECT_DOUBLE_EQ(law.missing_between(1.0, 3.0, 0.01), lubrication_resistance(2.0, 0.75, 0.01) - lubrication_resistance(2.0, 0.75, 0.06));
  for (const double gap : {1e-3, 1e-6, 0.0, -0.1}) EXPECT_EQ(law.missing_at_wall(1.0, gap), law.missing_at_wall(1.0, 1e-3));
  EXPECT_TRUE(std::isfinite(law.missing_at_wall(1.0, 0.0)));
}

TEST(Lubrication, ASideWithoutFrictionGivesAQuarter)
{
  const LubricationLaw open{.viscosity = 2.0, .wall_cutoff = 1e9, .pair_cutoff = 1e9, .minimum = 1e-9};
  EXPECT_NEAR(open.missing_at_mirror(1.0, 0.01) / open.missing_at_wall(1.0, 0.01), 0.25, 1e-9);
  EXPECT_EQ(law.missing_at_mirror(1.0, 0.03), 0.0);
  EXPECT_GT(law.missing_at_mirror(1.0, 0.029), 0.0);
}

TEST(Lubrication, IsThatOfAShortStep)
{
  EXPECT_NEAR(implicit_resistance(5.0, 1e-9, 1.0, 2.0), 5.0, 1e-6);
  EXPECT_EQ(implicit_resistance(5.0, 1e9, 0.0, 0.0), 5.0);  // both move as told
}

TEST(Lubrication, KineticEnergyNeverGrows)
{
  for (const double resistance_times_step : {1e-3, 1.0, 1e3, 1e12})
    for (const auto &mass : {std::vector<double>{1.0, 1.0}, {1.0, 1e-3, 1.0}, {1.0, 1.0, 1.0, 1.0, 1.0}, {1e-3, 5.0, 0.1, 2.0}}) {
      const auto E = energies(mass, resistance_times_step, 1.0);
      for (std::size_t k = 1; k < E.size(); k++) EXPECT_LE(E[k], E[k - 1] * (1.0 + 1e-14)) << resistance_times_step << ", " << mass.size();
    }
}
