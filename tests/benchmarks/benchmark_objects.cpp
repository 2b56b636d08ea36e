// Time per spring and per outline point of the objects' own kernels.
#include <benchmark/benchmark.h>

#include "liggghts_plugins/objects/outline.h"
#include "liggghts_plugins/objects/springs.h"

#include <vector>

using namespace swellflow;

namespace {

constexpr int ring_points = 20;

void per_item(benchmark::State &state, const char *name, double items)
{
  state.counters[name] = benchmark::Counter(items * static_cast<double>(state.iterations()), benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

/// 1000 discs, a little deformed.
std::vector<std::vector<Vector2>> rings()
{
  const Disk disk{.diameter = 0.12, .ring_points = ring_points, .density = 1500.0};
  std::vector<std::vector<Vector2>> all(1000);
  for (std::size_t o = 0; o < all.size(); ++o)
    for (int k = 0; k < ring_points; ++k) all[o].push_back(disk.ring_point(k) * (1.0 + 0.01 * std::sin(1.0 * k + o)));
  return all;
}

void springs(benchmark::State &state)
{
  const Disk disk{.diameter = 0.12, .ring_points = ring_points, .density = 1500.0};
  const auto all = rings();
  const Vector2 hub = Vector2::Zero();
  for (auto _ : state) {
    for (const auto &ring : all) {
      Vector2 sum = Vector2::Zero();
      for_each_spring(ring_points, [&](int a, int b, bool spoke) {
        sum += spring_force(ring[a], spoke ? hub : ring[b], spoke ? disk.spoke_length() : disk.ring_spring_length(), 1000.0);
      });
      benchmark::DoNotOptimize(sum);
    }
  }
  per_item(state, "per_spring", 2.0 * ring_points * all.size());
}

void outlines(benchmark::State &state)
{
  const auto all = rings();
  for (auto _ : state)
    for (const auto &ring : all) benchmark::DoNotOptimize(outline_shape(ring));
  per_item(state, "per_point", 1.0 * ring_points * all.size());
}

BENCHMARK(springs)->Unit(benchmark::kMicrosecond);
BENCHMARK(outlines)->Unit(benchmark::kMicrosecond);

}  // namespace

BENCHMARK_MAIN();
