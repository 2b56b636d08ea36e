// The coupled fluid between two of its steps, in a file and out of it.
#include <cmath>
#include <stdexcept>

#include "coupling/coupled_fluid.h"
#include "liggghts_plugins/options.h"

namespace swellflow {

namespace {

constexpr const char *side_names[] = {"xlo", "xhi", "ylo", "yhi", "zlo", "zhi"};

void require_same(const std::string &what, double in_file, double here)
{
  if (std::abs(in_file - here) <= 1e-12 * std::max(std::abs(in_file), std::abs(here))) return;
  throw std::invalid_argument("the fluid of the restart file must be that of this line, but " + what + " is " + shown(in_file) + " in the file and " +
                              shown(here) + " here; give it as it was, or leave the fluid out of the file: 'unfix' it above 'write_restart'");
}

}  // namespace

/// A fluid of another grid, or between other sides, cannot be continued. What it is made of may change, and how it is forced.
template <int Dim> void CoupledFluid<Dim>::require_same_box(Checkpoint &file)
{
  const Grid<Dim> &grid = flow_.grid();
  const auto compare = [&](const std::string &what, double here) {
    double number = here;
    file.number(what, number);
    require_same(what, number, here);
  };
  for (int d = 0; d < Dim; ++d) {
    const std::string direction(1, "xyz"[d]);
    compare("the number of cells in " + direction, grid.cells[d]);
    compare("the lower end of the box in " + direction, grid.origin[d]);
  }
  compare("the length of a cell", grid.h);
  for (int side = 0; side < 2 * Dim; ++side)
    compare(std::string("the kind of side ") + side_names[side] + " (0 wall, 1 slip, 2 periodic, 3 inflow, 4 parabolic inflow, 5 outflow)",
            static_cast<double>(options_.sides[side]));
}

template <int Dim> void CoupledFluid<Dim>::keep(Checkpoint &file)
{
  require_same_box(file);
  flow_.keep(file);
  flow_rate_.keep(file);
  file.number("fluid step", dt_);
  file.number("fluid step before", dt_before_);
  file.number("last fluid step", last_dt_);
  file.flag("some inflate", some_inflate_);
  file.common("last body force", last_body_force_.data(), Dim);
  for (auto &[name, sum] : std::initializer_list<std::pair<const char *, VecD *>>{{"given", &given_}, {"received", &received_}, {"given late", &given_late_},
                                                                                 {"owed", &owed_balance_}, {"balance", &balance_},
                                                                                 {"given by sides", &given_by_sides_}, {"given by growth", &given_by_growth_}})
    file.parts(name, sum->data(), Dim);
  for (auto &[name, sum] : std::initializer_list<std::pair<const char *, double *>>{{"exchanged", &exchanged_}, {"outflow", &outflow_},
                                                                                   {"sum of slip", &slip_sum_}, {"number of slips", &slip_count_}})
    file.parts(name, sum, 1);
  for (auto &[name, largest] : std::initializer_list<std::pair<const char *, double *>>{{"marker gap", &marker_gap_}, {"last marker gap", &last_marker_gap_},
                                                                                       {"largest slip", &slip_max_}, {"largest divergence", &max_divergence_}})
    file.parts(name, largest, 1, Checkpoint::Of::maximum);
}

template <int Dim> void CoupledFluid<Dim>::save(const std::string &file)
{
  CheckpointWriter writer(file, flow_.grid().comm);
  keep(writer);
  for (const auto &scalar : scalars_) scalar->keep(writer);
  writer.close();
}

template <int Dim> void CoupledFluid<Dim>::load(const std::string &file, long begin, long end)
{
  loaded_ = std::make_unique<CheckpointReader>(file, begin, end, flow_.grid().comm);
  keep(*loaded_);
}

template void CoupledFluid<2>::save(const std::string &);
template void CoupledFluid<2>::load(const std::string &, long, long);

}  // namespace swellflow
