// Time of a step of swelling objects without fluid and contact, LIGGGHTS included, per mass point: how objects are moved, and how many there are.
#include <benchmark/benchmark.h>
#include <mpi.h>

#include <sstream>
#include <string>

#include "lammps.h"
#include "library.h"
#include "liggghts_plugins/register_styles.h"

namespace {

constexpr int points = 21;

/// Discs of 20 points and a hub in rows of 100, disturbed a little.
class Objects {
public:
  Objects(int number, const std::string &integrator)
  {
    const char *arguments[] = {"benchmark", "-screen", "/dev/null", "-log", "none"};
    lammps_open(5, const_cast<char **>(arguments), MPI_COMM_WORLD, &handle_);
    swellflow::register_styles(static_cast<LAMMPS_NS::LAMMPS *>(handle_), {});
    const std::string rows = std::to_string(number / 100), height = std::to_string(0.2 * (number / 100));
    std::istringstream script(
        "units si\ndimension 2\natom_style hybrid granular molecular\natom_modify map array\nboundary f f p\nnewton off\ncommunicate single vel yes\n"
        "region box block 0 20 0 " + height + " -0.5 0.5 units box\ncreate_box 1 box\nneighbor 0.05 bin\nneigh_modify delay 0\n"
        "create_objects lattice 100 " + rows + " origin 0.1 0.1 spacing 0.2 disk diameter 0.12 points 20 density 1500\n"
        "variable speed atom 1e-4*sin(id)\nvelocity all set v_speed 0 0 units box\nfix springs all mass_spring stiffness 1e3\n"
        "fix grow all swell linear rate 1e-4 max 0.15\nfix move all " + integrator + "\ntimestep 1e-3\nrun 5\n");
    for (std::string line; std::getline(script, line);) lammps_command(handle_, line.c_str());
  }
  ~Objects() { lammps_close(handle_); }
  void run(int steps) { lammps_command(handle_, ("run " + std::to_string(steps) + " pre no post no").c_str()); }

private:
  void *handle_ = nullptr;
};

void step(benchmark::State &state, const std::string &integrator)
{
  const int number = static_cast<int>(state.range(0));
  Objects objects(number, integrator);
  for (auto _ : state) objects.run(10);
  state.counters["per_point"] =
      benchmark::Counter(10.0 * state.iterations() * number * points, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}
BENCHMARK_CAPTURE(step, explicit_, "nve/cds")->Arg(100)->Arg(2000)->Arg(20000)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(step, implicit, "nve/cds implicit")->Arg(100)->Arg(2000)->Arg(20000)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(step, conserving, "nve/cds implicit energy conserve")->Arg(100)->Arg(2000)->Arg(20000)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(step, rigid, "rigid/cds")->Arg(100)->Arg(2000)->Arg(20000)->Unit(benchmark::kMillisecond);

}  // namespace
