// What the flow solver tells of its state.
#include <algorithm>
#include <cmath>

#include "fluid/flow_solver.h"

namespace swellflow {

namespace {

/// Not a number counts as infinite, so that no maximum passes over it.
double largest_of(double largest, double value) { return value <= largest ? largest : std::isnan(value) ? HUGE_VAL : value; }

double largest_over_ranks(double value, MPI_Comm comm)
{
  MPI_Allreduce(MPI_IN_PLACE, &value, 1, MPI_DOUBLE, MPI_MAX, comm);
  return value;
}

}  // namespace

template <int Dim> template <class F> void FlowSolver<Dim>::each_cell(F &&f) const
{
  for (int k = 0; k < layout_.planes(); ++k)
    for (int r = 0; r < layout_.rows(); ++r)
      for (int i = 0; i < layout_.row_length(); ++i) f(layout_.row(k, r) + i);
}

template <int Dim> double FlowSolver<Dim>::largest_divergence_here() const
{
  double largest = 0.0;
  each_cell([&](std::ptrdiff_t cell) {
    double divergence = 0.0;
    for (int d = 0; d < Dim; ++d) divergence += face_velocity_[d][cell + layout_.stride(d)] - face_velocity_[d][cell];
    if (sources_) divergence -= grid_.h * sources_->rate()[cell];
    largest = largest_of(largest, std::abs(divergence));
  });
  return largest / grid_.h;
}

template <int Dim> double FlowSolver<Dim>::max_divergence() const { return largest_over_ranks(largest_divergence_here(), grid_.comm); }

template <int Dim> double FlowSolver<Dim>::max_speed_sum() const
{
  double largest = 0.0;
  each_cell([&](std::ptrdiff_t cell) {
    double sum = 0.0;
    for (int c = 0; c < Dim; ++c) sum += std::abs(u_[c][cell]);
    largest = largest_of(largest, sum);
  });
  return largest_over_ranks(largest, grid_.comm);
}

template <int Dim> double FlowSolver<Dim>::kinetic_energy() const
{
  double sum = 0.0;
  each_cell([&](std::ptrdiff_t cell) {
    for (int c = 0; c < Dim; ++c) sum += u_[c][cell] * u_[c][cell];
  });
  MPI_Allreduce(MPI_IN_PLACE, &sum, 1, MPI_DOUBLE, MPI_SUM, grid_.comm);
  return 0.5 * fluid_.density * grid_.cell_volume() * sum;
}

template <int Dim> Vec<Dim> FlowSolver<Dim>::mean_velocity() const
{
  Vec<Dim> mean{};
  each_cell([&](std::ptrdiff_t cell) {
    for (int c = 0; c < Dim; ++c) mean[c] += u_[c][cell];
  });
  MPI_Allreduce(MPI_IN_PLACE, mean.data(), Dim, MPI_DOUBLE, MPI_SUM, grid_.comm);
  double cells = 1.0;
  for (int d = 0; d < Dim; ++d) cells *= grid_.cells[d];
  for (double &value : mean) value /= cells;
  return mean;
}

template double FlowSolver<2>::largest_divergence_here() const;
template double FlowSolver<2>::max_divergence() const;
template double FlowSolver<2>::max_speed_sum() const;
template double FlowSolver<2>::kinetic_energy() const;
template Vec<2> FlowSolver<2>::mean_velocity() const;

}  // namespace swellflow
