// Moves objects under their springs by implicit steps, which no spring limits: style nve/cds with the word implicit.
#pragma once

#include "fix_object_integrator.h"
#include "objects/implicit_springs.h"

namespace LAMMPS_NS {

class FixMassSpring;

class FixNveCdsImplicit : public FixObjectIntegrator {
 public:
  FixNveCdsImplicit(class LAMMPS *, int, char **);

  void init() override;
  void setup(int) override;
  void initial_integrate(int) override;
  double compute_scalar() override;

 protected:
  void move(const swellflow::ObjectPoints &object, swellflow::PointBody &body, const std::vector<swellflow::Vector2> &excess) override;

 private:
  const FixMassSpring *springs_of(const swellflow::ObjectPoints &object) const;
  void require_springs() const;
  void require_convergence();

  swellflow::ImplicitSprings solver_;
  std::vector<const FixMassSpring *> springs_;
  long moved_objects_, iterations_before_;  // of this rank, in the last step
  int failed_object_;                       // 0: none has
};

/// Style nve/cds: explicit, or implicit.
Fix *create_nve_cds(class LAMMPS *, int narg, char **arg);

}  // namespace LAMMPS_NS
