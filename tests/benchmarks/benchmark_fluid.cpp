// Time per cell of a whole fluid step, beside a 2-D DCT-II/III pair of the same size in the same run, and time per marker.
#include <benchmark/benchmark.h>
#include <mpi.h>

#include <cmath>
#include <random>

#include "fluid/flow_solver.h"
#include "fluid/markers.h"

using namespace swellflow;

namespace {

void per_item(benchmark::State &state, const char *name, double items)
{
  state.counters[name] = benchmark::Counter(items * static_cast<double>(state.iterations()), benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

/// The floor that a whole step is measured against: FFTW's measured plan.
void dct_pair(benchmark::State &state)
{
  const int n = static_cast<int>(state.range(0));
  double *a = fftw_alloc_real(static_cast<std::size_t>(n) * n);
  fftw_plan there = fftw_plan_r2r_2d(n, n, a, a, FFTW_REDFT10, FFTW_REDFT10, FFTW_MEASURE);
  fftw_plan back = fftw_plan_r2r_2d(n, n, a, a, FFTW_REDFT01, FFTW_REDFT01, FFTW_MEASURE);
  for (int i = 0; i < n * n; ++i) a[i] = std::sin(0.37 * i);
  for (auto _ : state) {
    fftw_execute(there);
    fftw_execute(back);
    state.PauseTiming();  // the pair is not normalised
    for (int i = 0; i < n * n; ++i) a[i] *= 0.25 / n / n;
    state.ResumeTiming();
  }
  per_item(state, "per_cell", 1.0 * n * n);
  fftw_destroy_plan(there);
  fftw_destroy_plan(back);
  fftw_free(a);
}

class Cavity {
public:
  explicit Cavity(int n, MPI_Comm comm = MPI_COMM_SELF, Advection advection = Advection::central)
      : grid({n, n}, {}, 1.0 / n, comm), flow(grid, {1.0, 0.01}, lid(), advection), dt(0.3 / n)
  {
    for (int s = 0; s < 3; ++s) step();
  }
  void step()
  {
    flow.predict_velocity(dt);
    flow.project(dt);
  }
  Grid<2> grid;
  FlowSolver<2> flow;
  double dt;

private:
  static Boundaries<2> lid()
  {
    Boundaries<2> walls;
    walls.velocity[3] = {1.0, 0.0};
    return walls;
  }
};

void fluid_step(benchmark::State &state)
{
  const int n = static_cast<int>(state.range(0));
  Cavity cavity(n);
  for (auto _ : state) cavity.step();
  per_item(state, "per_cell", 1.0 * n * n);
}

/// All ranks together: mpirun -np N benchmark_fluid --benchmark_filter=on_all_ranks. The number of steps is fixed, so that no rank waits for ever.
void fluid_step_on_all_ranks(benchmark::State &state)
{
  const int n = static_cast<int>(state.range(0));
  Cavity cavity(n, MPI_COMM_WORLD);
  MPI_Barrier(MPI_COMM_WORLD);
  for (auto _ : state) cavity.step();
  per_item(state, "per_cell", 1.0 * n * n);
}

void fluid_step_bounded_advection(benchmark::State &state)
{
  const int n = static_cast<int>(state.range(0));
  Cavity cavity(n, MPI_COMM_SELF, Advection::bounded);
  for (auto _ : state) cavity.step();
  per_item(state, "per_cell", 1.0 * n * n);
}

/// A new step length: the factors of the viscous solve.
void new_factors(benchmark::State &state)
{
  const int n = static_cast<int>(state.range(0));
  Cavity cavity(n);
  const Ends walls{End::value, End::value};
  DirectSolver<2> solver(cavity.grid, cavity.flow.layout(), {walls, walls});
  double c = 0.01;
  for (auto _ : state) solver.set_operator(1.0, c *= 1.0001);
  per_item(state, "per_cell", 1.0 * n * n);
}

void prediction(benchmark::State &state)
{
  const int n = static_cast<int>(state.range(0));
  Cavity cavity(n);
  for (auto _ : state) cavity.flow.predict_velocity(cavity.dt);
  per_item(state, "per_cell", 1.0 * n * n);
}

void projection(benchmark::State &state)
{
  const int n = static_cast<int>(state.range(0));
  Cavity cavity(n);
  for (auto _ : state) cavity.flow.project(cavity.dt);
  per_item(state, "per_cell", 1.0 * n * n);
}

void helmholtz_solve(benchmark::State &state)
{
  const int n = static_cast<int>(state.range(0));
  Cavity cavity(n);
  const Ends walls{End::value, End::value};
  const auto solver = std::make_shared<DirectSolver<2>>(cavity.grid, cavity.flow.layout(), AllEnds<2>{walls, walls});
  solver->set_operator(1.0, 0.01);
  JointSolve<2, 1> solve(cavity.flow.layout(), {solver});
  Field<2> x(cavity.flow.layout());
  for (auto _ : state) solve({&x}, [](int) {}, [](int) {});
  per_item(state, "per_cell", 1.0 * n * n);
}

/// Circles of 31 markers a cell apart (D = 10 h), as in a bed.
class Circles {
public:
  explicit Circles(Cavity &cavity) : markers(make_markers<2>("roma_1999", cavity.flow.grid(), cavity.flow.layout()))
  {
    const double h = cavity.grid.h;
    for (double y = 10.5 * h; y < 1.0 - 6 * h; y += 13 * h)
      for (double x = 10.5 * h; x < 1.0 - 6 * h; x += 13 * h)
        for (int k = 0; k < 31; ++k) positions.push_back({x + 5 * h * std::cos(k * 0.2027), y + 5 * h * std::sin(k * 0.2027)});
    markers->place(positions);
    values.assign(positions.size(), Vec<2>{1e-9, 2e-9});
  }
  std::vector<Vec<2>> positions, values;
  std::unique_ptr<Markers<2>> markers;
};

void markers_place(benchmark::State &state)
{
  Cavity cavity(static_cast<int>(state.range(0)));
  Circles circles(cavity);
  for (auto _ : state) circles.markers->place(circles.positions);
  per_item(state, "per_marker", 1.0 * circles.positions.size());
}

void markers_interpolate(benchmark::State &state)
{
  Cavity cavity(static_cast<int>(state.range(0)));
  Circles circles(cavity);
  for (auto _ : state) circles.markers->interpolate(cavity.flow.face_velocity(), circles.values);
  per_item(state, "per_marker", 1.0 * circles.positions.size());
}

void markers_spread(benchmark::State &state)
{
  Cavity cavity(static_cast<int>(state.range(0)));
  Circles circles(cavity);
  for (auto _ : state) circles.markers->spread(circles.values, 1.0, cavity.flow.forcing());
  per_item(state, "per_marker", 1.0 * circles.positions.size());
}

BENCHMARK(dct_pair)->RangeMultiplier(2)->Range(256, 2048)->Unit(benchmark::kMillisecond);
BENCHMARK(fluid_step)->RangeMultiplier(2)->Range(256, 2048)->Unit(benchmark::kMillisecond);
BENCHMARK(fluid_step_on_all_ranks)->Arg(1024)->Iterations(60)->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK(fluid_step_bounded_advection)->Arg(512)->Unit(benchmark::kMillisecond);
BENCHMARK(new_factors)->Arg(512)->Unit(benchmark::kMillisecond);
BENCHMARK(prediction)->Arg(512)->Unit(benchmark::kMillisecond);
BENCHMARK(projection)->Arg(512)->Unit(benchmark::kMillisecond);
BENCHMARK(helmholtz_solve)->Arg(512)->Unit(benchmark::kMillisecond);
BENCHMARK(markers_place)->Arg(512)->Unit(benchmark::kMicrosecond);
BENCHMARK(markers_interpolate)->Arg(512)->Unit(benchmark::kMicrosecond);
BENCHMARK(markers_spread)->Arg(512)->Unit(benchmark::kMicrosecond);

}  // namespace
