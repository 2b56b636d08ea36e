// Time of a whole coupled step, LIGGGHTS included: a bed of soft discs in a fluid, per marker and per cell, and the share of the fluid alone.
#include <benchmark/benchmark.h>
#include <mpi.h>

#include <string>

#include "coupling/coupled_fluid.h"
#include "library.h"
#include "liggghts_plugins/fix_fluid_ib.h"
#include "liggghts_plugins/register_styles.h"
#include "lammps.h"
#include "modify.h"

using namespace LAMMPS_NS;

namespace {

/// side x side discs of D = 10 h, 20 points each, k_s = 1000, in 14 h of room.
class Bed {
public:
  explicit Bed(int side)
  {
    const char *arguments[] = {"benchmark", "-screen", "/dev/null", "-log", "none"};
    lammps_open(5, const_cast<char **>(arguments), MPI_COMM_WORLD, &handle_);
    swellflow::register_styles(lammps(), {swellflow::make_coupled_fluid, {}});
    const std::string n = std::to_string(side), cells = std::to_string(14 * side), length = std::to_string(0.14 * side);
    for (const std::string &line :
         {std::string("units si"), std::string("dimension 2"), std::string("atom_style hybrid granular molecular"), std::string("atom_modify map array"),
          std::string("boundary f f p"), std::string("newton off"), std::string("communicate single vel yes"), std::string("soft_particles yes"),
          "region box block 0 " + length + " 0 " + length + " -0.005 0.005 units box", std::string("create_box 1 box"), std::string("neighbor 0.01 bin"),
          std::string("neigh_modify delay 0 exclude molecule all"), std::string("fix m1 all property/global kn peratomtypepair 1 1e4"),
          std::string("fix m2 all property/global kt peratomtypepair 1 1e4"), std::string("fix m3 all property/global gamman_abs peratomtypepair 1 0"),
          std::string("fix m4 all property/global gammat_abs peratomtypepair 1 0"),
          std::string("fix m5 all property/global coefficientFriction peratomtypepair 1 0.3"),
          std::string("pair_style gran model hooke/stiffness tangential history absolute_damping on"), std::string("pair_coeff * *"),
          "create_objects lattice " + n + " " + n + " origin 0.07 0.07 spacing 0.14 disk diameter 0.1 points 20 density 1500 cds 0.2 type 1",
          std::string("fix springs all mass_spring stiffness 1000 restitution 1"), std::string("fix move all nve/cds"), std::string("fix flat all enforce2d"),
          "fix water all fluid/ib cells " + cells + " " + cells + " density 1000 viscosity 0.01 wall yhi velocity 0.1 0", std::string("timestep 1e-3"),
          std::string("run 10")})
      lammps_command(handle_, line.c_str());
  }
  ~Bed() { lammps_close(handle_); }

  void run(int steps) { lammps_command(handle_, ("run " + std::to_string(steps) + " pre no post no").c_str()); }
  const swellflow::FluidPartner &fluid() const
  {
    return *static_cast<FixFluidIb *>(lammps()->modify->fix[lammps()->modify->find_fix("water")])->partner();
  }

private:
  LAMMPS *lammps() const { return static_cast<LAMMPS *>(handle_); }
  void *handle_ = nullptr;
};

void coupled_step(benchmark::State &state)
{
  const int side = static_cast<int>(state.range(0));
  Bed bed(side);
  const double fluid = bed.fluid().seconds_in_fluid(), coupling = bed.fluid().seconds_in_coupling();
  for (auto _ : state) bed.run(10);
  const double steps = 10.0 * static_cast<double>(state.iterations()), objects = 1.0 * side * side;
  const auto rate = benchmark::Counter::kIsRate | benchmark::Counter::kInvert;
  state.counters["per_step"] = benchmark::Counter(steps, rate);
  state.counters["per_object"] = benchmark::Counter(steps * objects, rate);
  state.counters["per_cell_in_fluid_ns"] = 1e9 * (bed.fluid().seconds_in_fluid() - fluid) / (steps * 196.0 * objects);
  // 20 ring points of 1.6 h: two markers each.
  state.counters["per_marker_in_coupling_ns"] = 1e9 * (bed.fluid().seconds_in_coupling() - coupling) / (steps * 40.0 * objects);
}
BENCHMARK(coupled_step)->Arg(4)->Arg(16)->Unit(benchmark::kMillisecond);

}  // namespace
