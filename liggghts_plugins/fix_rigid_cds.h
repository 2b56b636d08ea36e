// Moves objects as rigid bodies that may swell.
#pragma once

#include "fix_object_integrator.h"

namespace LAMMPS_NS {

class FixRigidCds : public FixObjectIntegrator {
 public:
  FixRigidCds(class LAMMPS *, int, char **);

 protected:
  void move(const swellflow::ObjectPoints &object, swellflow::PointBody &body, const std::vector<swellflow::Vector2> &excess) override;

 private:
  std::vector<swellflow::Vector2> rest_;
};

}  // namespace LAMMPS_NS
