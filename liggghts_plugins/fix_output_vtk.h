// Writes frames for ParaView at an interval. The fix decides when and which objects; the OutputPartner writes.
#pragma once

#include <memory>

#include "fix.h"
#include "output_partner.h"
#include "output_times.h"

namespace LAMMPS_NS {

class FixOutputVtk : public Fix {
 public:
  FixOutputVtk(class LAMMPS *, int narg, char **arg, const swellflow::OutputPartnerFactory &make_partner);

  int setmask() override;
  void init() override;
  void setup(int) override;
  void end_of_step() override;
  void write_restart(FILE *) override;
  void restart(char *) override;

 private:
  const swellflow::FluidPartner *fluid() const;
  bool needs_fluid() const { return !options_.fields.empty(); }
  bool draws_objects() const { return options_.outline || options_.points || options_.cds; }
  bool needs_objects() const { return draws_objects() || options_.centres; }
  int place_of(const char *style) const;
  void require_own_folder();
  void require_fields();
  void collect_objects(swellflow::OutputFrame &frame) const;
  void collect_points(swellflow::OutputFrame &frame) const;
  void write_frame();

  swellflow::OutputOptions options_;
  std::unique_ptr<swellflow::OutputPartner> partner_;
  OutputTimes times_;
};

}  // namespace LAMMPS_NS
