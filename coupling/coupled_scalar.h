// A scalar that the coupled fluid carries, and the markers that meet it.
#pragma once

#include "coupling/courier.h"
#include "fluid/scalar_transport.h"
#include "liggghts_plugins/fluid_partner.h"

namespace swellflow {

template <int Dim> class CoupledFluid;

template <int Dim> class CoupledScalar final : public ScalarPartner {
public:
  /// Collective.
  CoupledScalar(CoupledFluid<Dim> &fluid, const ScalarOptions &options);

  void step(const std::array<double, 6> &side_values, const std::vector<double> *withdrawal, std::vector<ScalarMet> &met) override;
  std::vector<double> values_at(const std::vector<Triple> &places) override;
  ScalarReport report() override;

  /// Its state goes into a checkpoint, or comes from it. Collective.
  void keep(Checkpoint &file);
  const std::string &name() const { return name_; }
  const Field<Dim> &values() const { return transport_.values(); }
  double seconds() const { return seconds_; }

private:
  void withdraw(const std::vector<double> &by_point);
  void require_finite() const;
  std::array<int, Dim> cell_of(const Triple &place) const;

  CoupledFluid<Dim> &fluid_;
  const Grid<Dim> &grid_;
  const Layout<Dim> &layout_;
  std::string name_;
  ScalarTransport<Dim> transport_;
  Courier to_slabs_;
  std::vector<double> at_markers_;
  double total_at_start_ = 0.0;  // this rank's part
  double seconds_ = 0.0;
};

}  // namespace swellflow
