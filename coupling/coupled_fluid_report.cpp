// What the coupled fluid tells of itself: its balance, its slip, its fields.
#include "coupling/coupled_fluid.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "coupling/stopwatch.h"

namespace swellflow {

/// Sum over the faces of this rank of what the forcing as it stands gives to the fluid.
template <int Dim> typename CoupledFluid<Dim>::VecD CoupledFluid<Dim>::given_to_fluid() const
{
  const auto &layout = flow_.layout();
  const auto &forcing = flow_.forcing();
  VecD sum{};
  for (int k = 0; k < layout.planes(); ++k) {
    if (!forcing.touched(k)) continue;
    for (int c = 0; c < Dim; ++c)
      for (int r = 0; r < layout.rows(); ++r) {
        const double *f = forcing.faces(c) + layout.row(k, r);
        for (int i = 0; i < layout.row_length(); ++i) sum[c] += f[i];
      }
  }
  for (double &s : sum) s *= options_.density * flow_.grid().cell_volume();
  return sum;
}

template <int Dim> void CoupledFluid<Dim>::note_sides()
{
  given_by_sides_ = {};
  for (const VecD &impulse : flow_.side_impulses_here())
    for (int d = 0; d < Dim; ++d) given_by_sides_[d] += impulse[d];
  given_by_growth_ = flow_.source_impulse_here();
  outflow_ = flow_.outflow_here();
}

/// The fluid at the markers after the projection, less the velocity that it was forced to.
template <int Dim> void CoupledFluid<Dim>::measure_slip()
{
  Stopwatch watch(seconds_in_coupling_);
  markers_->interpolate(flow_.face_velocity_around(), u_after_);
  slip_sum_ = slip_count_ = slip_max_ = 0.0;
  for (std::size_t l = 0; l < u_after_.size(); ++l) {
    double square = 0.0;
    for (int d = 0; d < Dim; ++d) {
      const double slip = wanted_[l][d] - u_after_[l][d];
      square += slip * slip;
    }
    slip_sum_ += std::sqrt(square);
    slip_count_ += 1.0;
    slip_max_ = std::max(slip_max_, std::sqrt(square));
  }
  max_divergence_ = flow_.largest_divergence_here();
}

/// In one message with whether the flow is finite.
template <int Dim> void CoupledFluid<Dim>::agree_on_slip()
{
  double sums[] = {std::isfinite(max_divergence_) ? 0.0 : 1.0, slip_sum_, slip_count_};
  MPI_Allreduce(MPI_IN_PLACE, sums, 3, MPI_DOUBLE, MPI_SUM, flow_.grid().comm);
  require_finite_flow(sums[0]);
  mean_slip_ = sums[2] > 0.0 ? sums[1] / sums[2] : 0.0;
}

/// Ends the run on all ranks alike before a flow that has blown up is taken for one that stands still. not_finite: on how many ranks.
template <int Dim> void CoupledFluid<Dim>::require_finite_flow(double not_finite) const
{
  if (not_finite > 0.0)
    throw NotFinite("the fluid's velocity must stay finite, but it is not after a fluid step of length " + std::to_string(last_dt_) +
                    ": use a smaller 'timestep' or 'every', 'cfl 0.5', or 'advection bounded' where the grid is too coarse for the flow");
}

template <int Dim> FluidReport CoupledFluid<Dim>::report()
{
  FluidReport report;
  report.cfl = flow_.max_speed_sum() * last_dt_ / flow_.grid().h;
  report.kinetic_energy = flow_.kinetic_energy();
  report.step = last_dt_;
  const VecD mean = flow_.mean_velocity();
  double mass = options_.density * flow_.grid().cell_volume();
  for (const int cells : flow_.grid().cells) mass *= cells;
  for (int d = 0; d < Dim; ++d) {
    report.mean_velocity[d] = mean[d];
    report.momentum[d] = mass * mean[d];
    report.driving_force[d] = options_.density * last_body_force_[d];
  }

  double sums[4 + 4 * Dim] = {slip_sum_, slip_count_, exchanged_, outflow_}, largest[3] = {slip_max_, last_marker_gap_, max_divergence_};
  for (int d = 0; d < Dim; ++d) {
    sums[4 + d] = balance_[d];
    sums[4 + Dim + d] = received_[d];
    sums[4 + 2 * Dim + d] = given_by_sides_[d];
    sums[4 + 3 * Dim + d] = given_by_growth_[d];
  }
  MPI_Allreduce(MPI_IN_PLACE, sums, 4 + 4 * Dim, MPI_DOUBLE, MPI_SUM, flow_.grid().comm);
  MPI_Allreduce(MPI_IN_PLACE, largest, 3, MPI_DOUBLE, MPI_MAX, flow_.grid().comm);

  report.mean_slip = sums[1] > 0.0 ? sums[0] / sums[1] : 0.0;
  report.max_slip = largest[0];
  report.marker_gap = largest[1];
  report.max_divergence = largest[2];
  report.outflow = sums[3];
  double error = 0.0;
  for (int d = 0; d < Dim; ++d) {
    if (last_dt_ > 0.0) {
      report.force_on_objects[d] = sums[4 + Dim + d] / last_dt_;
      report.force_of_sides[d] = sums[4 + 2 * Dim + d] / last_dt_;
      report.force_of_growth[d] = sums[4 + 3 * Dim + d] / last_dt_;
    }
    error = std::max(error, std::abs(sums[4 + d]));
  }
  if (sums[2] > 0.0) report.momentum_error = error / sums[2];
  return report;
}

template <int Dim> std::vector<PhaseTime> CoupledFluid<Dim>::phase_times() const
{
  std::vector<PhaseTime> times;
  for (int phase = 0; phase < PhaseClock::n_phases; ++phase)
    times.push_back({PhaseClock::names[phase], flow_.clock().seconds(static_cast<PhaseClock::Phase>(phase))});
  times.push_back({"markers", seconds_in_coupling_});
  if (!scalars_.empty()) times.push_back({"scalars", seconds_in_scalars()});
  return times;
}

template <int Dim> FieldBlock CoupledFluid<Dim>::field_block() const
{
  const Grid<Dim> &grid = flow_.grid();
  FieldBlock block;
  for (int d = 0; d < Dim; ++d) {
    block.global_cells[d] = grid.cells[d];
    block.count[d] = flow_.layout().cells(d);
    block.origin[d] = grid.origin[d];
  }
  block.first[Grid<Dim>::last] = grid.first_plane;
  block.spacing = grid.h;
  return block;
}

template <int Dim> std::vector<FieldInfo> CoupledFluid<Dim>::fields() const
{
  std::vector<FieldInfo> fields = {{"velocity", "length/time", 3}, {"pressure", "pressure", 1}};
  for (const auto &scalar : scalars_) fields.push_back({scalar->name(), "1", 1});
  return fields;
}

template <int Dim> void CoupledFluid<Dim>::copy_field(const std::string &name, std::vector<double> &values) const
{
  const auto &layout = flow_.layout();
  const auto scalar = std::find_if(scalars_.begin(), scalars_.end(), [&](const auto &one) { return one->name() == name; });
  values.clear();
  for (int k = 0; k < layout.planes(); ++k)
    for (int r = 0; r < layout.rows(); ++r)
      for (int i = 0; i < layout.row_length(); ++i) {
        const std::ptrdiff_t at = layout.row(k, r) + i;
        if (scalar != scalars_.end()) {
          values.push_back((*scalar)->values()[at]);
          continue;
        }
        if (name == "pressure") {
          values.push_back(options_.density * flow_.pressure_over_density()[at]);
          continue;
        }
        for (int c = 0; c < 3; ++c) values.push_back(c < Dim ? flow_.velocity()[c][at] : 0.0);
      }
}

template class CoupledFluid<2>;

}  // namespace swellflow
