// Writes frames for ParaView at an interval. The fix decides when and which objects; the OutputPartner writes.
#pragma once

#include <memory>

#include "fix.h"
#include "output_partner.h"

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
  int pack_comm(int n, int *list, double *buf, int pbc_flag, int *pbc) override;
  void unpack_comm(int n, int first, double *buf) override;

 private:
  const swellflow::FluidPartner *fluid() const;
  bool needs_fluid() const { return !options_.fields.empty(); }
  bool needs_objects() const { return options_.outline || options_.points || options_.cds; }
  int place_of(const char *style) const;
  void require_own_folder();
  void require_fields();
  void collect_objects(swellflow::OutputFrame &frame) const;
  void collect_points(swellflow::OutputFrame &frame);
  void write_frame();
  double time() const;

  swellflow::OutputOptions options_;
  std::unique_ptr<swellflow::OutputPartner> partner_;
  swellflow::OutputFrame *frame_;  // being filled, for pack_comm and unpack_comm
  bigint last_step_;               // of the frame written last; -1: none
  double restart_time_;            // at which an earlier run saved; -1: none did
  double time_offset_;             // LIGGGHTS counts time anew after read_restart
};

}  // namespace LAMMPS_NS
