#include "gravity.h"

#include "fix_gravity.h"
#include "lammps.h"
#include "modify.h"

using namespace LAMMPS_NS;

std::vector<Gravity> LAMMPS_NS::gravities(LAMMPS *lmp)
{
  std::vector<Gravity> all;
  for (int k = 0; k < lmp->modify->nfix; k++) {
    auto *fix = dynamic_cast<FixGravity *>(lmp->modify->fix[k]);
    if (!fix) continue;
    all.push_back({.groupbit = fix->groupbit});
    fix->get_gravity(all.back().acceleration.data());
  }
  return all;
}

swellflow::Triple LAMMPS_NS::total_gravity(LAMMPS *lmp)
{
  swellflow::Triple sum{};
  for (const Gravity &one : gravities(lmp))
    for (int d = 0; d < 3; d++) sum[d] += one.acceleration[d];
  return sum;
}
