#include "limits.h"

#include "contact_limits.h"
#include "fix.h"
#include "modify.h"

using namespace LAMMPS_NS;

namespace swellflow {

namespace {

template <typename Visit>
void for_each_who_knows(LAMMPS *lmp, const Visit &visit)
{
  for (int k = 0; k < lmp->modify->nfix; k++)
    if (auto *knows = dynamic_cast<KnowsFigures *>(lmp->modify->fix[k])) visit(*knows);
}

}  // namespace

std::vector<Figure> limits_of(LAMMPS *lmp)
{
  std::vector<Figure> figures;
  for_each_who_knows(lmp, [&](KnowsFigures &one) { one.add_limits(figures); });
  add_contact_step(lmp, figures, 1.0, 2.0);
  return figures;
}

std::vector<Figure> accuracy_of(LAMMPS *lmp)
{
  std::vector<Figure> figures;
  for_each_who_knows(lmp, [&](KnowsFigures &one) { one.add_accuracy(figures); });
  add_contact_step(lmp, figures, 0.3, 1.0);  // a fifth of the time of a collision, as is usual
  add_overlap(lmp, figures);
  return figures;
}

}  // namespace swellflow
