// Time per spring and per outline point of the objects' own kernels.
#include <benchmark/benchmark.h>

#include "liggghts_plugins/objects/outline.h"
#include "tests/unit/ring_object.h"

#include "liggghts_plugins/objects/implicit_springs.h"
#include "liggghts_plugins/objects/spring_forces.h"

#include <numeric>
#include <vector>

using namespace swellflow;

namespace {

constexpr int ring_points = 20;

void per_item(benchmark::State &state, const char *name, double items)
{
  state.counters[name] = benchmark::Counter(items * static_cast<double>(state.iterations()), benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

/// 1000 discs, a little deformed.
std::vector<PointBody> bodies()
{
  const swellflow_test::RingObject object{.diameter = 0.12, .mass = 17.0};
  std::vector<PointBody> all(1000, object.body());
  for (std::size_t o = 0; o < all.size(); ++o)
    for (int k = 0; k < ring_points; ++k) all[o].x[k] *= 1.0 + 0.01 * std::sin(1.0 * k + o);
  return all;
}

void springs(benchmark::State &state)
{
  const auto all = bodies();
  const SpringSet set = swellflow_test::RingObject{.diameter = 0.12, .mass = 17.0, .law = {.stiffness = 1000.0}}.springs();
  std::vector<double> x;
  for (const auto &body : all)
    for (int k = 0; k <= ring_points; ++k) x.insert(x.end(), {body.x[k].x(), body.x[k].y(), 0.0});
  std::vector<int> ring(ring_points);
  std::iota(ring.begin(), ring.end(), 0);
  SpringForces forces;
  for (auto _ : state) {
    for (std::size_t o = 0; o < all.size(); ++o) {
      forces.gather(ring.data(), ring_points, ring_points, &x[3 * o * (ring_points + 1)], nullptr);
      forces.find(set, {});
      benchmark::DoNotOptimize(forces.springs(0)[ring_points]);
    }
  }
  per_item(state, "per_spring", 2.0 * ring_points * all.size());
}

/// Steps of 5 ms at the stiffness that the argument gives, in a fluid that resists: the discs keep moving.
void implicit_steps(benchmark::State &state)
{
  const SpringSet set = swellflow_test::RingObject{.diameter = 0.12, .mass = 17.0, .law = {.stiffness = static_cast<double>(state.range(0))}}.springs();
  auto all = bodies();
  const std::vector<Vector2> none(ring_points + 1, Vector2::Zero());
  ImplicitSprings solver(SpringEnergy::conserve);
  long steps = 0;
  for (auto _ : state)
    for (auto &body : all) solver.advance(body, set, none, 5e-3), ++steps;
  per_item(state, "per_point", (ring_points + 1.0) * all.size());
  state.counters["iterations"] = static_cast<double>(solver.newton_iterations()) / steps;
}

void outlines(benchmark::State &state)
{
  auto all = bodies();
  for (auto &body : all) body.x.pop_back();
  for (auto _ : state)
    for (const auto &body : all) benchmark::DoNotOptimize(outline_shape(body.x));
  per_item(state, "per_point", 1.0 * ring_points * all.size());
}

BENCHMARK(springs)->Unit(benchmark::kMicrosecond);
BENCHMARK(implicit_steps)->Arg(1000)->Arg(100000000)->Unit(benchmark::kMicrosecond);
BENCHMARK(outlines)->Unit(benchmark::kMicrosecond);

}  // namespace

BENCHMARK_MAIN();
