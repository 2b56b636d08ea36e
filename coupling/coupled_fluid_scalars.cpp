// The scalars that the coupled fluid carries, and their way between points and markers.
#include <algorithm>

#include "coupling/coupled_fluid.h"

namespace swellflow {

template <int Dim> bool CoupledFluid<Dim>::add_scalar(const ScalarOptions &options)
{
  scalars_.push_back(std::make_unique<CoupledScalar<Dim>>(*this, options));
  if (!loaded_ || !loaded_->has("scalar " + options.name)) return false;
  scalars_.back()->keep(*loaded_);
  return true;
}

template <int Dim> void CoupledFluid<Dim>::remove_scalar(const std::string &name)
{
  std::erase_if(scalars_, [&](const auto &scalar) { return scalar->name() == name; });
}

template <int Dim> ScalarPartner *CoupledFluid<Dim>::scalar(const std::string &name)
{
  for (const auto &scalar : scalars_)
    if (scalar->name() == name) return scalar.get();
  return nullptr;
}

template <int Dim> double CoupledFluid<Dim>::seconds_in_scalars() const
{
  double sum = 0.0;
  for (const auto &scalar : scalars_) sum += scalar->seconds();
  return sum;
}

/// By way of the points' accounts: the markers on their outlines get the value, those inside 0.
template <int Dim> void CoupledFluid<Dim>::tell_markers(const std::vector<double> &by_point, std::vector<double> &by_marker)
{
  std::vector<double> told, leaving(leaving_.size(), 0.0);
  Arrivals<double> arrived, arrived_at_slabs;
  for (const int point : reporting_) told.push_back(by_point[point]);
  to_homes_.deliver_again(told, arrived);
  for (std::size_t n = 0; n < arrived.size(); ++n) {
    const Account &account = accounts_[arrived_reports_[n].slot];
    std::fill_n(leaving.begin() + account.first, account.n_carrying, arrived[n]);
  }
  to_slabs_.deliver_again(leaving, arrived_at_slabs);
  by_marker.assign(arrived_at_slabs.begin(), arrived_at_slabs.end());
}

template <int Dim> void CoupledFluid<Dim>::hear_markers(const std::vector<double> &by_marker, std::vector<ScalarMet> &by_point)
{
  Arrivals<double> back;
  std::vector<ScalarMet> sums;
  Arrivals<ScalarMet> here;
  to_slabs_.reply(by_marker, back);
  for (const Report &report : arrived_reports_) {
    const Account &account = accounts_[report.slot];
    ScalarMet sum;
    for (int m = account.first; m < account.first + account.n_carrying; ++m) {
      sum.amount += leaving_.spacing[m] * back[m];
      sum.spacing += leaving_.spacing[m];
    }
    sums.push_back(sum);
  }
  to_homes_.reply(sums, here);
  by_point.assign(points_.n_own(), {});
  for (std::size_t n = 0; n < reporting_.size(); ++n) by_point[reporting_[n]] = here[n];
}

template class CoupledFluid<2>;

}  // namespace swellflow
