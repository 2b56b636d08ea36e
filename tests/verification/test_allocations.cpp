// A step of the fluid takes no memory from the heap once the first steps are done.
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <cstdlib>
#include <new>

#include "fluid/flow_solver.h"
#include "fluid/marker_solver.h"

namespace {

std::atomic<long> allocations{0};

void *counted(std::size_t size)
{
  ++allocations;
  if (void *p = std::malloc(size ? size : 1)) return p;
  throw std::bad_alloc();
}

}  // namespace

void *operator new(std::size_t size) { return counted(size); }
void *operator new[](std::size_t size) { return counted(size); }
void operator delete(void *p) noexcept { std::free(p); }
void operator delete[](void *p) noexcept { std::free(p); }
void operator delete(void *p, std::size_t) noexcept { std::free(p); }
void operator delete[](void *p, std::size_t) noexcept { std::free(p); }

using namespace swellflow;

namespace {

/// A circle of markers that is forced to rest, directly or implicitly, in a stream between given sides.
long allocations_in_ten_steps(const Boundaries<2> &boundaries, bool implicit)
{
  const Grid<2> grid({48, 32}, {}, 1.0 / 32, MPI_COMM_WORLD, boundaries.periodic());
  FlowSolver<2> flow(grid, {1.0, 0.01}, boundaries);
  const auto markers = make_markers<2>("roma_1999", flow.grid(), flow.layout());
  MarkerSolver<2> solver(flow.grid(), flow.layout(), *markers);
  std::vector<Vec<2>> places, velocities, impulses;
  for (int l = 0; l < 20; ++l) {
    const Vec<2> x{0.6 + 0.1 * std::cos(0.314 * l), 0.5 + 0.1 * std::sin(0.314 * l)};
    if (grid.rank_of_plane(static_cast<int>(x[1] / grid.h)) == grid.rank) places.push_back(x);
  }
  const std::vector<double> spacing(places.size(), grid.h);
  const auto step = [&] {
    flow.forcing().clear();
    flow.predict_velocity(0.01);
    markers->place(places);
    markers->interpolate(flow.face_velocity_around(), velocities);
    for (auto &u : velocities)
      for (double &component : u) component = -component;
    if (implicit) {
      solver.solve(spacing, velocities, 1.0, impulses);
    } else {
      impulses = velocities;
      for (auto &j : impulses)
        for (double &component : j) component *= 2.0 * grid.h * grid.h;
    }
    markers->spread(impulses, 1.0, flow.forcing());
    flow.forcing().complete();
    flow.apply_forcing();
    flow.project(0.01);
  };
  for (int s = 0; s < 3; ++s) step();
  const long before = allocations;
  for (int s = 0; s < 10; ++s) step();
  return allocations - before;
}

TEST(Allocations, NoneInAStep)
{
  Boundaries<2> channel;
  channel.kind = {Boundary::parabolic_inflow, Boundary::outflow, Boundary::wall, Boundary::slip};
  channel.velocity[0] = {1.0, 0.0};
  Boundaries<2> periodic;
  periodic.kind.fill(Boundary::periodic);
  for (const auto &boundaries : {Boundaries<2>{}, channel, periodic})
    for (const bool implicit : {false, true}) EXPECT_EQ(allocations_in_ten_steps(boundaries, implicit), 0);
}

TEST(Allocations, AreCounted)
{
  const long before = allocations;
  delete new int(1);
  std::vector<double> some(10);
  EXPECT_GE(allocations - before, 1);
}

}  // namespace
