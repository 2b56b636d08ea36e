// The measures of how slow swelling is: their formulas, and how they are summed.
#include <gtest/gtest.h>

#include <cmath>

#include "liggghts_plugins/objects/swelling_pace.h"

using swellflow::PaceOfFluid;
using swellflow::PaceOfObject;
using swellflow::SwellingPace;

namespace {

constexpr PaceOfObject bead{.closing_speed = 2e-3, .diameter = 0.1, .area = 0.008, .density = 1500.0, .pressure = 30.0};

}  // namespace

TEST(SwellingPace, IsTheInertialNumberWithoutAFluid)
{
  SwellingPace pace;
  pace.add(bead, {});
  EXPECT_NEAR(pace.against_contacts(), 2e-3 * std::sqrt(1500.0 / 30.0), 1e-16);
  EXPECT_EQ(pace.against_flow(), 0.0);
}

TEST(SwellingPace, AddsTheViscousNumberInAFluid)
{
  SwellingPace pace;
  const PaceOfFluid water{.density = 1000.0, .kinematic_viscosity = 1e-3, .speed = 0.04};
  pace.add(bead, water);
  const double I = 2e-3 * std::sqrt(1500.0 / 30.0), J = 1000.0 * 1e-3 * (2e-3 / 0.1) / 30.0;
  EXPECT_NEAR(pace.against_contacts(), std::sqrt(I * I + J / 0.635), 1e-15);
  EXPECT_NEAR(pace.against_flow(), 2e-3 / (1e-3 / 0.1 + 0.04), 1e-15);
}

TEST(SwellingPace, CountsOnlyWhatGrowsAndIsPressed)
{
  SwellingPace pace;
  PaceOfObject still = bead, free = bead, pulled = bead;
  still.closing_speed = 0.0;
  free.pressure = 0.0;
  pulled.pressure = -5.0;
  for (const PaceOfObject &one : {still, free, pulled}) pace.add(one, {});
  EXPECT_EQ(pace.against_contacts(), 0.0);
}

TEST(SwellingPace, IsAMeanOverTheAreaThatIsGrown)
{
  PaceOfObject fast = bead, slow = bead;
  fast.closing_speed = 3 * slow.closing_speed;
  fast.pressure = 2 * slow.pressure;
  SwellingPace one, other;
  one.add(fast, {});
  other.add(slow, {});
  const double inertia = 3 * 9 + 1, work = 3 * 2 + 1;  // in units of the slow one's
  SwellingPace both = one;
  both.add(slow, {});
  EXPECT_NEAR(both.against_contacts(), other.against_contacts() * std::sqrt(inertia / work), 1e-15);
  const std::array<double, 2> a = one.sums(), b = other.sums();
  EXPECT_EQ(SwellingPace::of({a[0] + b[0], a[1] + b[1]}, 0.25).against_contacts(), both.against_contacts());
  EXPECT_EQ(SwellingPace::of(a, 0.25).against_flow(), 0.25);
}
