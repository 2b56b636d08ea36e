// From the slabs back to the points, and what these have received to the accounts of their markers.
#include <cmath>

#include "coupling/coupled_fluid.h"
#include "coupling/stopwatch.h"
#include "liggghts_plugins/fluid_columns.h"

namespace swellflow {

template <int Dim> void CoupledFluid<Dim>::hand_out()
{
  Stopwatch watch(seconds_in_coupling_);
  to_slabs_.reply(answers_, answers_here_);

  for (std::size_t n = 0; n < accounts_.size(); ++n) {
    const Account &account = accounts_[n];
    double *law = points_.law[account.point], *home = points_.home[account.point];
    for (int m = account.first; m < account.first + account.count; ++m) {
      const auto &[u, kappa] = answers_here_[m];
      law[FluidLaw::KAPPA] += kappa;
      for (int d = 0; d < Dim; ++d) law[FluidLaw::A_X + d] += kappa * (u[d] - leaving_.offset[m][d]);
    }
    for (int d = 0; d < Dim; ++d) law[FluidLaw::A_X + d] -= account.felt[d];
    home[FluidHome::HAS_MARKERS] = 1.0;
    home[FluidHome::HOME_RANK] = flow_.grid().rank;
    home[FluidHome::HOME_SLOT] = static_cast<double>(n);
  }
}

/// Points may have migrated since the step began: each reports to where its account is.
template <int Dim> void CoupledFluid<Dim>::collect(const std::vector<ObjectPoints> &objects)
{
  Stopwatch watch(seconds_in_coupling_);
  reports_.clear();
  reporting_.clear();
  to_.clear();
  received_ = {};
  exchanged_ = 0.0;
  for (const ObjectPoints &object : objects)
    for (int k = -1; k < object.n_ring; ++k) {
      const int i = points_.own_index(k < 0 ? object.hub : object.ring[k]);
      if (i < 0) continue;
      const double *impulse = points_.impulse[i], *home = points_.home[i];
      Report report{static_cast<int>(home[FluidHome::HOME_SLOT]), {}};
      for (int d = 0; d < Dim; ++d) {
        report.impulse[d] = impulse[d] - home[FluidHome::INNER_FORCE_X + d] * dt_;
        received_[d] += report.impulse[d];
      }
      if (home[FluidHome::HAS_MARKERS] == 0.0) continue;
      reports_.push_back(report);
      reporting_.push_back(i);
      to_.push_back(static_cast<int>(home[FluidHome::HOME_RANK]));
    }
  to_homes_.deliver(reports_, to_, arrived_reports_);
  // Objects may have been deleted.
  if (arrived_reports_.size() == accounts_.size()) leaving_change_.resize(leaving_.size());
  else leaving_change_.assign(leaving_.size(), VecD{});
  new_force_.clear();
  for (const Report &report : arrived_reports_) new_force_.push_back(settle(report));
  to_homes_.reply(new_force_, new_force_here_);
  for (std::size_t n = 0; n < reporting_.size(); ++n)
    for (int d = 0; d < Dim; ++d) points_.carried[reporting_[n]][FluidCarried::FORCE_X + d] = new_force_here_[n][d];
  to_slabs_.deliver_again(leaving_change_, change_);
}

/// From the impulse of the fluid around, I = dt [ sum of kappa (u~ - c) - (sum of kappa) V - felt ] the point's mean velocity V, and from it each marker's part. The new F_c.
template <int Dim> typename CoupledFluid<Dim>::VecD CoupledFluid<Dim>::settle(const Report &report)
{
  const Account &account = accounts_[report.slot];
  const int end = account.first + account.count;
  double sum_kappa = 0.0;
  VecD V, change{}, force;
  for (int d = 0; d < Dim; ++d) V[d] = -report.impulse[d] / dt_ - account.felt[d];
  for (int m = account.first; m < end; ++m) {
    const auto &[u, kappa] = answers_here_[m];
    sum_kappa += kappa;
    for (int d = 0; d < Dim; ++d) V[d] += kappa * (u[d] - leaving_.offset[m][d]);
  }
  for (double &v : V) v /= sum_kappa;
  for (int m = account.first; m < end; ++m) {
    const auto &[u, kappa] = answers_here_[m];
    const bool carries = m < account.first + account.n_carrying;
    for (int d = 0; d < Dim; ++d) {
      const double impulse = kappa * dt_ * (V[d] + leaving_.offset[m][d] - u[d]);
      leaving_change_[m][d] = impulse;
      if (carries) change[d] += impulse;
    }
  }
  double square = 0.0;
  for (int d = 0; d < Dim; ++d) {
    force[d] = account.carried[d] + change[d] / dt_;
    square += force[d] * force[d];
  }
  exchanged_ += std::sqrt(square) * dt_;
  return force;
}

template class CoupledFluid<2>;

}  // namespace swellflow
