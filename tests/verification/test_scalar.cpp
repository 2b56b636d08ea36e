// A scalar that is carried and diffuses: orders, bounds, exact solutions, balance. Velocities are given, not solved for.
#include <gtest/gtest.h>

#include <numbers>

#include "flow.h"
#include "scalar_scene.h"

namespace {

using namespace swellflow;
using swellflow_test::expect_second_order;
using Scene = swellflow_test::ScalarScene;
using std::numbers::pi;
using Sides = ScalarTransport<2>::Sides;
using enum ScalarSide;
constexpr double round_off = 1e-13;

constexpr std::array<bool, 2> both = {true, true}, along_x = {true, false}, none = {false, false};

// ---- order -----------------------------------------------------------------------------------------------------------------------------------

/// Error of a wave that travels across both directions and decays.
double travelling_wave(int n, double diffusivity)
{
  const double u = 1.0, v = 0.5, h = 1.0 / n, dt = 0.25 * h, until = 0.5, decay = 8.0 * pi * pi * diffusivity;
  Scene scene(n, n, h, both, diffusivity, {});
  const auto exact = [&](double t) {
    return [=](double x, double y) { return 1.0 + 0.5 * std::exp(-decay * t) * std::sin(2.0 * pi * (x - u * t + y - v * t)); };
  };
  scene.start(exact(0.0));
  scene.uniform_flow(u, v);
  scene.run(until, dt);
  EXPECT_LT(scene.imbalance(), round_off);
  return scene.error(exact(until));
}

/// The limiter clips extrema, so that without diffusion the error is of an order between 1.5 and 2.
TEST(ScalarOrder, CarriedWave)
{
  const double coarse = travelling_wave(64, 0.0), fine = travelling_wave(128, 0.0), order = std::log2(coarse / fine);
  EXPECT_GT(order, 1.5) << coarse << " " << fine;
  EXPECT_LT(order, 2.2) << coarse << " " << fine;
}

TEST(ScalarOrder, CarriedAndDiffusingWave) { expect_second_order(travelling_wave(64, 5e-3), travelling_wave(128, 5e-3)); }

/// z = 0.45: implicit, and Crank-Nicolson. Both kinds of sides in one direction.
double decaying_mode(int n)
{
  const double h = 1.0 / n, decay = (0.25 + 4.0) * pi * pi, until = 0.05;
  Scene scene(n, n, h, along_x, 1.0, {open, open, value, open});
  const auto exact = [&](double t) { return [=](double x, double y) { return std::exp(-decay * t) * std::sin(0.5 * pi * y) * std::cos(2.0 * pi * x); }; };
  scene.start(exact(0.0));
  scene.run(until, 0.4 * h * h);
  EXPECT_LT(scene.imbalance(), round_off);
  return scene.error(exact(until));
}

TEST(ScalarOrder, DiffusionBetweenSides) { expect_second_order(decaying_mode(16), decaying_mode(32)); }

/// A blob that a vortex winds up, at one h: the error of 10, 18, 36 and 72 steps against 720. The first two are implicit (z w = 1.9 and 1.06), the others are not.
TEST(ScalarOrder, TimeStep)
{
  const int n = 32;
  const double h = 1.0 / n, until = 4.0 * h, diffusivity = 4.75 * h * h / until;
  const auto after = [&](int steps) {
    Scene scene(n, n, h, none, diffusivity, {});
    scene.start([](double x, double y) { return std::exp(-20.0 * (std::pow(x - 0.4, 2) + std::pow(y - 0.3, 2))); });
    scene.flow([](double x, double y) { return 0.3 * std::sin(pi * x) * std::sin(pi * y); });
    scene.run(until, until / steps);
    return scene;
  };
  const Scene fine = after(720);
  const double implicit_order = std::log(after(10).difference(fine) / after(18).difference(fine)) / std::log(1.8);
  EXPECT_GT(implicit_order, 1.8);
  EXPECT_LT(implicit_order, 2.3);
  expect_second_order(after(36).difference(fine), after(72).difference(fine));
}

// ---- bounds ----------------------------------------------------------------------------------------------------------------------------------

/// Squares of 0 and 1 in a vortex through all of a closed box, at CFL numbers up to 3; D from none to where a step reaches across many cells.
TEST(ScalarBounds, NoNewExtrema)
{
  const int n = 32;
  const double h = 1.0 / n, dt = 3.0 * h;
  for (const double z : {0.0, 0.2, 0.45, 1.0, 100.0}) {
    SCOPED_TRACE(z);
    Scene scene(n, n, h, none, z * h * h / dt, {});
    scene.start([](double x, double y) { return std::fmod(std::floor(8 * x) + std::floor(8 * y), 2.0); });
    scene.flow([](double x, double y) { return std::sin(pi * x) * std::sin(pi * y) / pi; });
    for (int s = 0; s < 20; ++s) {
      scene.scalar.advance(dt, scene.faces, false);
      scene.expect_within(0.0, 1.0);
    }
    EXPECT_GT(scene.scalar.sub_steps(), 3);
    EXPECT_LT(scene.imbalance(), round_off);
  }
}

/// A flow that has gone astray does not keep its scalar busy for ever.
TEST(ScalarBounds, AFlowThatIsTooFastToFollow)
{
  Scene scene(16, 16, 1.0 / 16, both, 0.0, {});
  scene.start([](double, double) { return 1.0; });
  scene.uniform_flow(1e15, 0.0);
  EXPECT_THROW(scene.run(1.0, 1.0), std::runtime_error);
}

/// From a uniform start, with a value on one side and another flowing in.
TEST(ScalarBounds, NoneAtSidesEither)
{
  for (const double z : {0.1, 0.3, 1.0, 30.0}) {
    SCOPED_TRACE(z);
    Scene scene(16, 16, 1.0 / 16, none, z / 16 / 0.5, {value, open, value, feed});
    for (int side = 0; side < 4; ++side) scene.scalar.set_side_value(side, side == 0 ? 1.0 : 0.0);
    scene.start([](double, double) { return 0.5; });
    scene.uniform_flow(0.6, -0.4);
    for (int s = 0; s < 30; ++s) {
      scene.scalar.advance(0.5 / 16, scene.faces, false);
      scene.expect_within(0.0, 1.0);
    }
    EXPECT_LT(scene.imbalance(), round_off);
  }
}

// ---- exact solutions -------------------------------------------------------------------------------------------------------------------------

/// u c' = D c'' between two values, along x and along y; Péclet number 10.
double boundary_layer(int n, bool along_x)
{
  const double h = 1.0 / n, u = 1.0, diffusivity = 0.1;
  const Sides sides = along_x ? Sides{value, value, open, open} : Sides{open, open, value, value};
  Scene scene(along_x ? n : 8, along_x ? 8 : n, h, {!along_x, along_x}, diffusivity, sides);
  scene.scalar.set_side_value(along_x ? 1 : 3, 1.0);
  scene.start([](double, double) { return 0.0; });
  scene.uniform_flow(along_x ? u : 0.0, along_x ? 0.0 : u);
  scene.run(3.0, 0.38 * h * h / diffusivity);
  EXPECT_LT(scene.imbalance(), round_off);
  return scene.error([&](double x, double y) { return std::expm1((along_x ? x : y) * u / diffusivity) / std::expm1(u / diffusivity); });
}

TEST(ScalarExact, ExponentialLayer)
{
  for (const bool x : {true, false}) expect_second_order(boundary_layer(32, x), boundary_layer(64, x));
}

/// Between a value of 2 and one of -1 the profile is linear; what comes in on one side leaves on the other.
TEST(ScalarExact, LinearBetweenValues)
{
  for (const bool along_y : {true, false}) {
    Scene scene(along_y ? 8 : 16, along_y ? 16 : 8, 1.0 / 16, {along_y, !along_y}, 0.1, along_y ? Sides{open, open, value, value} : Sides{value, value, open, open});
    scene.scalar.set_side_value(along_y ? 2 : 0, 2.0);
    scene.scalar.set_side_value(along_y ? 3 : 1, -1.0);
    scene.start([](double, double) { return 0.0; });
    scene.run(200.0, 0.5);
    EXPECT_LT(scene.error([&](double x, double y) { return 2.0 - 3.0 * (along_y ? y : x); }), 1e-12);
    const double before = scene.entered();
    scene.run(1.0, 0.5);
    // What enters at the value 2 goes down the slope; at the value -1 it leaves.
    EXPECT_NEAR(scene.entered() - before, 0.1 * 3.0 * 0.5, 1e-11);
    EXPECT_LT(scene.imbalance(), round_off);
  }
}

// ---- what the flow brings and takes ------------------------------------------------------------------------------------------------------------

/// Fed through a periodic side, along x and y, both ways, from rest between two walls faster and faster to their middle: before anything leaves there is in the box what the flow has brought,
/// so that the front is at U t in the mean. Later as much leaves as enters. The slabs of several ranks lie across y, so that the cut is between the last and the first.
TEST(ScalarFeed, FrontOfAPeriodicChannel)
{
  for (const double sign : {1.0, -1.0})
    for (const bool along_y : {true, false}) {
      const int n = 32;
      const double h = 1.0 / n, U = sign;  // the mean velocity
      const int side = (along_y ? 2 : 0) + (sign < 0.0);
      Sides sides{};
      sides[side] = feed;
      Scene scene(along_y ? 8 : n, along_y ? n : 8, h, std::array{!along_y, along_y}, 0.0, sides);
      scene.scalar.set_side_value(side, 1.0);
      scene.start([](double, double) { return 0.0; });
      // Across: 8 cells of h, s from 0 to 1; velocity 6 U s (1 - s).
      const double width = 8.0 * h;
      const auto volume = [&](double s) { return width * U * s * s * (3.0 - 2.0 * s); };
      scene.flow([&](double x, double y) { return along_y ? -volume(x / width) : volume(y / width); });
      scene.run(0.4, 0.02);
      EXPECT_NEAR(scene.total() / width, 0.4, 1e-13);
      EXPECT_LT(scene.left(), 1e-9);
      scene.expect_within(0.0, 1.0);
      scene.run(20.0, 0.02);
      EXPECT_LT(scene.imbalance(), round_off);
      EXPECT_NEAR(scene.entered(), 20.4 * width, 1e-11);
      EXPECT_NEAR(scene.total(), width, 2e-3 * width);
    }
}

/// A periodic side that is not fed brings back what left; fed at one side only, what flows in at the other is that of its own cells; nothing diffuses across a cut.
TEST(ScalarFeed, CutsOneDirectionAlone)
{
  Scene scene(16, 16, 1.0 / 16, both, 1.0, {open, open, open, feed});
  scene.scalar.set_side_value(3, 5.0);
  scene.start([](double x, double y) { return y > 0.5 ? 1.0 : 0.25 + 0.0 * x; });
  scene.uniform_flow(0.7, 0.0);
  scene.run(0.002, 1e-3);
  EXPECT_EQ(scene.entered(), 0.0);
  EXPECT_EQ(scene.left(), 0.0);
  // As between walls: the lowest cell knows nothing of the highest.
  Scene walls(16, 16, 1.0 / 16, along_x, 1.0, {});
  walls.start([](double x, double y) { return y > 0.5 ? 1.0 : 0.25 + 0.0 * x; });
  walls.run(0.002, 1e-3);
  EXPECT_LT(scene.difference(walls), 1e-13);
  scene.uniform_flow(0.0, 1.0);
  scene.run(0.05, 1e-3);
  scene.expect_within(0.25, 1.0);
  EXPECT_GT(scene.entered(), 0.0);
}

/// Fluid that appears everywhere has the value of its place: what is uniform stays so, and what appeared has left.
TEST(ScalarGrowth, UniformStaysUniform)
{
  Scene scene(16, 16, 1.0 / 16, none, 0.0, {});
  scene.start([](double, double) { return 0.75; });
  const double h = scene.grid.h;
  for (int k = 0; k <= scene.layout.planes(); ++k)
    for (int i = 0; i <= 16; ++i) {
      if (k < scene.layout.planes()) scene.faces[0][scene.layout.row(k, 0) + i] = i * h;
      if (i < 16) scene.faces[1][scene.layout.row(k, 0) + i] = (k + scene.grid.first_plane) * h;
    }
  scene.run(1.0, 0.02, true);
  EXPECT_LT(scene.error([](double, double) { return 0.75; }), 1e-13);
  EXPECT_NEAR(scene.appeared(), 1.5, 1e-12);
  EXPECT_LT(scene.imbalance(), round_off);
}

/// However much is asked for, no cell gives more than it has.
TEST(ScalarWithdrawal, LeavesNothingBelowZero)
{
  Scene scene(16, 16, 1.0 / 16, both, 0.0, {});
  scene.start([](double x, double) { return x; });
  Field<2> &withdrawal = scene.scalar.withdrawal();
  // In the ghosts of the upper end: meant for the lower one.
  if (scene.grid.rank == scene.grid.ranks - 1) withdrawal[scene.layout.row(scene.layout.planes(), 0) + 7] = 1e30;
  scene.each_cell([&](double, double y, std::ptrdiff_t at) { withdrawal[at] += y > 0.5 ? 1.0 : 0.0; });
  scene.scalar.withdraw();
  scene.expect_within(0.0, 1.0);
  EXPECT_NEAR(scene.withdrawn(), 0.25 * 0.5 + 7.5 / 16 / 256, 1e-15);
  EXPECT_LT(scene.imbalance(), round_off);
}

}  // namespace
