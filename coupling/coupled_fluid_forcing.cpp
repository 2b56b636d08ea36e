// Forcing that goes on after the points have moved, for a fluid that follows the markers more closely than one pass makes it.
#include "coupling/coupled_fluid.h"
#include "coupling/stopwatch.h"
#include "liggghts_plugins/fluid_columns.h"

namespace swellflow {

/// Spreads and gives it to the fluid.
template <int Dim> void CoupledFluid<Dim>::force(std::span<const VecD> impulses)
{
  spread(impulses);
  const VecD given = given_to_fluid();
  for (int d = 0; d < Dim; ++d) given_[d] += given[d];
  Stopwatch watch(seconds_in_fluid_);
  flow_.apply_forcing();
}

/// What the markers' velocities, as the points moved, still lack after the forcing; multi-direct forcing repeats that (Luo et al., Phys. Rev. E 76, 2007; Breugem, J.
/// Comput. Phys. 231, 2012), implicit forcing solves for all markers at once.
template <int Dim> void CoupledFluid<Dim>::tighten()
{
  wanted_.resize(u_.size());
  for (std::size_t l = 0; l < u_.size(); ++l)
    for (int d = 0; d < Dim; ++d) wanted_[l][d] = u_[l][d] + change_[l][d] / (answers_[l].kappa * dt_);
  if (options_.forcing == ForcingScheme::direct) return;

  all_extra_.assign(u_.size(), VecD{});
  extra_.resize(u_.size());
  const int loops = options_.forcing == ForcingScheme::multi ? options_.forcing_loops - 1 : 1;
  for (int loop = 0; loop < loops; ++loop) {
    find_remaining_slip();
    if (options_.forcing == ForcingScheme::implicit)
      marker_solver_->solve(spacing_, slip_, options_.density, extra_);
    else
      for (std::size_t l = 0; l < slip_.size(); ++l)
        for (int d = 0; d < Dim; ++d) extra_[l][d] = answers_[l].kappa * dt_ * slip_[l][d];
    force(extra_);
    for (std::size_t l = 0; l < extra_.size(); ++l)
      for (int d = 0; d < Dim; ++d) all_extra_[l][d] += extra_[l][d];
  }
  owe(all_extra_);
}

template <int Dim> void CoupledFluid<Dim>::find_remaining_slip()
{
  Stopwatch watch(seconds_in_coupling_);
  markers_->interpolate(flow_.face_velocity_around(), u_after_);
  slip_.resize(u_after_.size());
  for (std::size_t l = 0; l < slip_.size(); ++l)
    for (int d = 0; d < Dim; ++d) slip_[l][d] = wanted_[l][d] - u_after_[l][d];
}

/// The points have moved: their object receives this with the law of the next step. Until then the balance counts it as received. It is not carried: what the
/// next step still lacks it finds anew.
template <int Dim> void CoupledFluid<Dim>::owe(const std::vector<VecD> &extra)
{
  Stopwatch watch(seconds_in_coupling_);
  for (const VecD &impulse : extra)
    for (int d = 0; d < Dim; ++d) given_late_[d] += impulse[d];
  for (int d = 0; d < Dim; ++d) owed_balance_[d] -= given_late_[d];
  to_slabs_.reply(extra, extra_back_);
  owed_.clear();
  for (const Report &report : arrived_reports_) {
    const Account &account = accounts_[report.slot];
    VecD sum{};
    for (int m = account.first; m < account.first + account.count; ++m)
      for (int d = 0; d < Dim; ++d) sum[d] += extra_back_[m][d];
    owed_.push_back(sum);
  }
  to_homes_.reply(owed_, owed_here_);
  for (std::size_t n = 0; n < reporting_.size(); ++n)
    for (int d = 0; d < Dim; ++d) points_.carried[reporting_[n]][FluidCarried::OWED_X + d] = owed_here_[n][d];
}

template class CoupledFluid<2>;

}  // namespace swellflow
