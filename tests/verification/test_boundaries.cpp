// Each kind of side against flows that are known in closed form, and what no flow can obey.
#include <numbers>

#include "flow.h"
#include "fluid/flow_rate.h"

using namespace swellflow_test;

namespace {

constexpr double pi = std::numbers::pi;

// ---- flows between parallel plates -----------------------------------------------------------------------------------------------------------

TEST(ParallelPlates, CouetteIsExact)
{
  Boundaries<2> plates = sides(Boundary::periodic, Boundary::periodic, Boundary::wall, Boundary::wall);
  plates.velocity[2] = {-0.5, 0.0};
  plates.velocity[3] = {1.0, 0.0};
  Flow flow(8, 16, 1.0 / 16, 1.0, plates);
  flow.run(4.0, 0.004);
  EXPECT_LT(flow.error([](double, double y, double) -> Vec<2> { return {-0.5 + 1.5 * y, 0.0}; }), 1e-11);
}

// Across x, the direction of the transforms: between a free-slip side and a moving wall all moves with the wall.
TEST(ParallelPlates, FreeSlipCarriesNoShear)
{
  Boundaries<2> plates = sides(Boundary::slip, Boundary::wall, Boundary::periodic, Boundary::periodic);
  plates.velocity[1] = {0.0, 1.0};
  Flow flow(16, 8, 1.0 / 16, 1.0, plates);
  flow.run(16.0, 0.01);
  EXPECT_LT(flow.error([](double, double, double) -> Vec<2> { return {0.0, 1.0}; }), 1e-11);
}

// On cells the discrete profile is the exact one plus a constant, h^2 / 8 of the curvature: second order, and otherwise exact.
TEST(ParallelPlates, PoiseuilleByBodyForce)
{
  for (const bool across_y : {true, false}) {
    Boundaries<2> plates = across_y ? sides(Boundary::periodic, Boundary::periodic, Boundary::wall, Boundary::wall)
                                    : sides(Boundary::wall, Boundary::wall, Boundary::periodic, Boundary::periodic);
    const int n = 16;
    const double h = 1.0 / n, nu = 0.5;
    Flow flow(across_y ? 8 : n, across_y ? n : 8, h, nu, plates);
    flow.solver.set_body_force(across_y ? Vec<2>{8 * nu, 0.0} : Vec<2>{0.0, 8 * nu});
    flow.run(8.0, 0.01);
    const auto profile = [h](double s) { return 4.0 * s * (1.0 - s) + h * h; };
    const auto exact = [&](double x, double y, double) -> Vec<2> { return across_y ? Vec<2>{profile(y), 0.0} : Vec<2>{0.0, profile(x)}; };
    EXPECT_LT(flow.error(exact), 1e-11);
  }
}

TEST(ParallelPlates, FlowRateIsHeld)
{
  const double nu = 0.5;
  Flow flow(8, 32, 1.0 / 32, nu, sides(Boundary::periodic, Boundary::periodic, Boundary::wall, Boundary::wall));
  FlowRate<2> control({true, false});
  Vec<2> g{};
  for (int s = 0; s < 400; ++s) {
    control.update(flow.solver.mean_velocity(), {2.0, 0.0}, 0.02, g);
    flow.solver.set_body_force(g);
    flow.step(0.02);
  }
  EXPECT_NEAR(flow.solver.mean_velocity()[0], 2.0, 1e-9);
  EXPECT_NEAR(g[0], 12 * nu * 2.0, 0.003 * g[0]);  // dp/dx = 12 nu U / H^2
  EXPECT_EQ(g[1], 0.0);
}

// Stokes' second problem: a wall that oscillates, u = Re exp(i w t - (1 + i) y sqrt(w / 2 nu)); the velocity is given for the end of each step.
double oscillating_wall_error(int n, double dt)
{
  const double nu = 0.02, w = 2 * pi;
  const auto exact = [=](double, double y, double t) -> Vec<2> {
    const double k = std::sqrt(w / (2 * nu));
    return {std::exp(-k * y) * std::cos(w * t - k * y), 0.0};
  };
  Flow flow(8, 2 * n, 1.0 / n, nu, sides(Boundary::periodic, Boundary::periodic, Boundary::wall, Boundary::wall));
  flow.solver.set_side_velocity(2, {1.0, 0.0});
  flow.start(exact);
  const long steps = std::lround(1.0 / dt);
  for (long s = 1; s <= steps; ++s) {
    flow.solver.set_side_velocity(2, {std::cos(w * s * dt), 0.0});
    flow.step(dt);
  }
  return flow.error(exact);
}

TEST(ParallelPlates, WallsMayChangeTheirVelocity) { expect_second_order(oscillating_wall_error(32, 1.0 / 64), oscillating_wall_error(64, 1.0 / 128)); }

// ---- flows through the box -------------------------------------------------------------------------------------------------------------------

double channel_error(int n)
{
  Boundaries<2> through = sides(Boundary::parabolic_inflow, Boundary::outflow, Boundary::wall, Boundary::wall);
  through.velocity[0] = {1.0, 0.0};
  Flow flow(4 * n, n, 1.0 / n, 0.05, through);
  flow.run(10.0, 0.16 / n);
  EXPECT_LT(flow.solver.max_divergence(), 1e-11);
  return flow.error([](double, double y, double) -> Vec<2> { return {4 * y * (1 - y), 0.0}; });
}

TEST(ThroughFlow, ParabolicInflowStaysPoiseuille) { expect_second_order(channel_error(16), channel_error(32)); }

// The same through y, across slabs of ranks, out at the lower end.
TEST(ThroughFlow, WorksInTheDirectionOfTheSlabs)
{
  Boundaries<2> down = sides(Boundary::wall, Boundary::wall, Boundary::outflow, Boundary::parabolic_inflow);
  down.velocity[3] = {0.0, -1.0};
  Boundaries<2> along = sides(Boundary::parabolic_inflow, Boundary::outflow, Boundary::wall, Boundary::wall);
  along.velocity[0] = {1.0, 0.0};
  Flow one(32, 16, 1.0 / 16, 0.05, along), other(16, 32, 1.0 / 16, 0.05, down);
  one.run(4.0, 0.01);
  other.run(4.0, 0.01);
  const auto poiseuille = [](double s) { return 4 * s * (1 - s); };
  const double error_one = one.error([&](double, double y, double) -> Vec<2> { return {poiseuille(y), 0.0}; });
  const double error_other = other.error([&](double x, double, double) -> Vec<2> { return {0.0, -poiseuille(x)}; });
  EXPECT_NEAR(error_one, error_other, 1e-10);
}

// A Lamb-Oseen vortex in a stream leaves, and nothing of it is thrown back: what remains is small beside the vortex.
TEST(ThroughFlow, VorticesLeave)
{
  Boundaries<2> stream = sides(Boundary::inflow, Boundary::outflow, Boundary::slip, Boundary::slip);
  stream.velocity[0] = {1.0, 0.0};
  const int n = 32;
  Flow flow(3 * n, 2 * n, 1.0 / n, 1e-3, stream);
  const double strength = 0.5, core = 0.2;
  flow.start([=](double x, double y, double) -> Vec<2> {
    const double dx = x - 1.5, dy = y - 1.0, r2 = (dx * dx + dy * dy) / (core * core), v = strength / core * std::exp(0.5 * (1.0 - r2));
    return {1.0 - v * dy, v * dx};
  });
  const auto disturbance = [](double, double, const Vec<2> &u) { return std::hypot(u[0] - 1.0, u[1]); };
  const double before = flow.largest(disturbance);
  flow.run(4.5, 0.4 / n);
  EXPECT_GT(before, 0.45);
  EXPECT_LT(flow.largest(disturbance), 0.03 * before);
}

TEST(ThroughFlow, AsMuchLeavesAsEntersWhenTheInflowChanges)
{
  Boundaries<2> through = sides(Boundary::inflow, Boundary::outflow, Boundary::wall, Boundary::outflow);
  through.velocity[0] = {1.0, 0.0};
  Flow flow(32, 16, 1.0 / 16, 0.05, through);
  for (int s = 0; s < 50; ++s) {
    flow.solver.set_side_velocity(0, {1.0 + std::sin(0.3 * s), 0.0});
    flow.step(0.02);
    EXPECT_LT(flow.solver.max_divergence(), 1e-10);
  }
}

// ---- bounded advection -----------------------------------------------------------------------------------------------------------------------

TEST(BoundedAdvection, IsOfSecondOrderWhereTheFlowIsSmooth)
{
  const auto error = [](int n) {
    const double nu = 0.01;
    const auto exact = [nu](double x, double y, double t) -> Vec<2> {
      const double decay = std::exp(-8 * pi * pi * nu * t), a = 2 * pi * (x - t), b = 2 * pi * y;
      return {1.0 - std::cos(a) * std::sin(b) * decay, std::sin(a) * std::cos(b) * decay};
    };
    Flow flow(n, n, 1.0 / n, nu, sides(Boundary::periodic, Boundary::periodic, Boundary::periodic, Boundary::periodic), Advection::bounded);
    flow.start(exact);
    flow.run(0.5, 0.25 / n);
    return flow.error(exact);
  };
  const double order = std::log2(error(32) / error(64));
  EXPECT_GT(order, 1.5);  // the limiter clips the extrema
  EXPECT_LT(order, 2.6);
}

// A shear layer of one cell, carried along: central advection rings, bounded advection stays between the two streams.
TEST(BoundedAdvection, MakesNoNewExtrema)
{
  const auto overshoot = [](Advection advection) {
    const int n = 64;
    Flow flow(n, n, 1.0 / n, 1e-7, sides(Boundary::periodic, Boundary::periodic, Boundary::periodic, Boundary::periodic), advection);
    flow.start([](double x, double, double) -> Vec<2> { return {1.0, x > 0.25 && x < 0.75 ? 1.0 : 0.0}; });
    flow.run(0.25, 0.1 / n);
    return flow.largest([](double, double, const Vec<2> &u) { return std::max(u[1] - 1.0, -u[1]); });
  };
  EXPECT_LT(overshoot(Advection::bounded), 0.01);
  EXPECT_GT(overshoot(Advection::central), 0.1);
}

// ---- what cannot be ---------------------------------------------------------------------------------------------------------------------------

TEST(Boundaries, RefuseWhatNoFlowCanObey)
{
  const auto refused = [](const Boundaries<2> &boundaries) -> std::string {
    try {
      boundaries.require_solvable();
    } catch (const std::invalid_argument &refusal) {
      return refusal.what();
    }
    return "";
  };
  Boundaries<2> boundaries = sides(Boundary::inflow, Boundary::wall, Boundary::wall, Boundary::wall);
  boundaries.velocity[0] = {1.0, 0.0};
  EXPECT_NE(refused(boundaries).find("no outflow"), std::string::npos);
  boundaries.kind[1] = Boundary::outflow;
  EXPECT_EQ(refused(boundaries), "");
  boundaries.velocity[0] = {-1.0, 0.0};
  EXPECT_NE(refused(boundaries).find("into the box"), std::string::npos);
  EXPECT_NE(refused(sides(Boundary::periodic, Boundary::wall, Boundary::wall, Boundary::wall)).find("two periodic sides"), std::string::npos);
  EXPECT_EQ(refused(sides(Boundary::wall, Boundary::outflow, Boundary::wall, Boundary::wall)), "");
}

}  // namespace
