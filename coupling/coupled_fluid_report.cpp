// What the coupled fluid tells of itself: its balance, its slip, its fields.
#include "coupling/coupled_fluid.h"

#include <cmath>

namespace swellflow {

/// Sum over the faces of this rank of what the forcing as it stands gives to the fluid.
template <int Dim> typename CoupledFluid<Dim>::VecD CoupledFluid<Dim>::given_to_fluid() const
{
  const auto &layout = flow_.layout();
  const auto &forcing = const_cast<FlowSolver<Dim> &>(flow_).forcing();
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

template <int Dim> FluidReport CoupledFluid<Dim>::report()
{
  FluidReport report;
  report.max_divergence = flow_.max_divergence();
  report.cfl = dt_ > 0.0 ? flow_.max_speed_sum() * dt_ / flow_.grid().h : 0.0;
  report.kinetic_energy = flow_.kinetic_energy();

  // Slip: the fluid at the markers after the projection, against the velocity it was forced to, u~ + dJ / (kappa dt).
  std::vector<VecD> u_now;
  markers_.interpolate(flow_.face_velocity_around(), u_now);
  double sums[2 + 2 * Dim + 1] = {}, largest[2] = {0.0, marker_gap_};
  for (std::size_t l = 0; l < u_now.size() && l < change_.size(); ++l) {
    VecD slip;
    for (int d = 0; d < Dim; ++d) slip[d] = u_[l][d] + change_[l][d] / (answers_[l].kappa * dt_) - u_now[l][d];
    const double size = std::sqrt(std::inner_product(slip.begin(), slip.end(), slip.begin(), 0.0));
    sums[0] += size;
    sums[1] += 1.0;
    largest[0] = std::max(largest[0], size);
  }
  for (int d = 0; d < Dim; ++d) {
    sums[2 + d] = given_[d];
    sums[2 + Dim + d] = received_[d];
  }
  sums[2 + 2 * Dim] = exchanged_;
  MPI_Allreduce(MPI_IN_PLACE, sums, 2 + 2 * Dim + 1, MPI_DOUBLE, MPI_SUM, flow_.grid().comm);
  MPI_Allreduce(MPI_IN_PLACE, largest, 2, MPI_DOUBLE, MPI_MAX, flow_.grid().comm);

  if (sums[1] > 0.0) report.mean_slip = sums[0] / sums[1];
  report.max_slip = largest[0];
  report.marker_gap = largest[1];
  double error = 0.0;
  for (int d = 0; d < Dim; ++d) {
    if (dt_ > 0.0) report.force_on_objects[d] = sums[2 + Dim + d] / dt_;
    error = std::max(error, std::abs(sums[2 + d] + sums[2 + Dim + d]));
  }
  if (sums[2 + 2 * Dim] > 0.0) report.momentum_error = error / sums[2 + 2 * Dim];
  return report;
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
  return {{"velocity", "length/time", 3}, {"pressure", "pressure", 1}};
}

template <int Dim> void CoupledFluid<Dim>::copy_field(const std::string &name, std::vector<double> &values) const
{
  const auto &layout = flow_.layout();
  values.clear();
  for (int k = 0; k < layout.planes(); ++k)
    for (int r = 0; r < layout.rows(); ++r)
      for (int i = 0; i < layout.row_length(); ++i) {
        const std::ptrdiff_t at = layout.row(k, r) + i;
        if (name == "pressure") {
          values.push_back(options_.density * flow_.pressure_over_density()[at]);
          continue;
        }
        for (int c = 0; c < 3; ++c) values.push_back(c < Dim ? flow_.velocity()[c][at] : 0.0);
      }
}

template class CoupledFluid<2>;

}  // namespace swellflow
