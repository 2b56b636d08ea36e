// The fluid around the objects, as a script names it. The fix parses, keeps what must migrate with the points, and says when; the FluidPartner computes.
#pragma once

#include <memory>

#include "fix.h"
#include "fluid_partner.h"

namespace LAMMPS_NS {

class FixPropertyAtom;

class FixFluidIb : public Fix {
 public:
  FixFluidIb(class LAMMPS *, int narg, char **arg, const swellflow::FluidPartnerFactory &make_partner);

  int setmask() override;
  void post_create() override;
  void pre_delete(bool unfixflag) override;
  void init() override;
  void setup(int vflag) override;
  void pre_initial_integrate() override;
  void post_force(int) override;
  void end_of_step() override;
  double compute_scalar() override;
  double compute_vector(int n) override;

  /// Null before the first run.
  const swellflow::FluidPartner *partner() const { return partner_.get(); }

 private:
  void parse(int narg, char **arg);
  void require_settings();
  void make_partner();
  void require_integrators();
  void require_same_step();
  FixPropertyAtom *make_property(const char *name, int columns, bool on_ghosts);
  const std::vector<swellflow::ObjectPoints> &objects();
  std::array<double, 3> gravity() const;
  const swellflow::FluidReport &report();

  swellflow::FluidOptions options_;
  swellflow::FluidPartnerFactory make_partner_;
  std::unique_ptr<swellflow::FluidPartner> partner_;
  FixPropertyAtom *carried_ = nullptr;
  std::vector<swellflow::ObjectPoints> objects_;
  double dt_ = 0.0;       // of the fluid step under way
  int dem_step_ = 0;  // within the fluid step; 0: none is under way
  swellflow::FluidReport report_;
  bigint reported_step_ = -1;
};

}  // namespace LAMMPS_NS
