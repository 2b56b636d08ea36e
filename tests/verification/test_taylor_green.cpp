// Taylor-Green vortices: the solver's orders in space and time, between periodic and between free-slip sides.
#include <numbers>

#include "flow.h"

using namespace swellflow_test;

namespace {

constexpr double pi = std::numbers::pi;

// Periodic, carried along by a mean flow (1, 1/2), so that advection has something to do.
class CarriedVortices : public Flow {
public:
  CarriedVortices(int n, double dt, double change_of_step)
      : Flow(n, n, 1.0 / n, nu, sides(Boundary::periodic, Boundary::periodic, Boundary::periodic, Boundary::periodic))
  {
    start(exact);
    const long steps = std::lround(0.5 / dt);
    for (long s = 0; s < steps; ++s) step(dt * (1.0 + change_of_step * (s % 2 ? 1.0 : -1.0)));
    EXPECT_LT(solver.max_divergence(), 1e-11);
  }
  static Vec<2> exact(double x, double y, double t)
  {
    const double decay = std::exp(-8 * pi * pi * nu * t), a = 2 * pi * (x - t), b = 2 * pi * (y - 0.5 * t);
    return {1.0 - std::cos(a) * std::sin(b) * decay, 0.5 + std::sin(a) * std::cos(b) * decay};
  }

private:
  static constexpr double nu = 0.01;
};

double periodic_vortex_error(int n, double dt, double change_of_step = 0.0)
{
  return CarriedVortices(n, dt, change_of_step).error(CarriedVortices::exact);
}

TEST(TaylorGreen, PeriodicSecondOrderInSpace) { expect_second_order(periodic_vortex_error(16, 1.0 / 512), periodic_vortex_error(32, 1.0 / 512)); }

TEST(TaylorGreen, PeriodicSecondOrderInSpaceAndTime) { expect_second_order(periodic_vortex_error(32, 1.0 / 64), periodic_vortex_error(64, 1.0 / 128)); }

// Against smaller steps on the same grid, so that only the error of the time step counts.
TEST(TaylorGreen, PeriodicSecondOrderInTime)
{
  for (const double change_of_step : {0.0, 0.3}) {
    const auto difference = [change_of_step](double dt) {
      return CarriedVortices(32, dt, change_of_step).difference(CarriedVortices(32, dt / 2, change_of_step));
    };
    expect_second_order(difference(1.0 / 128), difference(1.0 / 256));
  }
}

TEST(TaylorGreen, PeriodicSecondOrderWhenTheStepChanges)
{
  expect_second_order(periodic_vortex_error(32, 1.0 / 64, 0.3), periodic_vortex_error(64, 1.0 / 128, 0.3));
}

// Four vortices between free-slip sides.
double box_vortex_error(int n, double dt)
{
  const double nu = 0.02;
  const auto exact = [nu](double x, double y, double t) -> Vec<2> {
    const double decay = std::exp(-8 * pi * pi * nu * t);
    return {std::sin(2 * pi * x) * std::cos(2 * pi * y) * decay, -std::cos(2 * pi * x) * std::sin(2 * pi * y) * decay};
  };
  Flow flow(n, n, 1.0 / n, nu, sides(Boundary::slip, Boundary::slip, Boundary::slip, Boundary::slip));
  flow.start(exact);
  flow.run(0.5, dt);
  EXPECT_LT(flow.solver.max_divergence(), 1e-11);
  return flow.error(exact);
}

TEST(TaylorGreen, FreeSlipBoxSecondOrder)
{
  expect_second_order(box_vortex_error(64, 1.0 / 512), box_vortex_error(128, 1.0 / 1024));
}

}  // namespace
