#include "contact_partners.h"

#include <algorithm>
#include <vector>

#include "all_ranks.h"
#include "atom.h"
#include "fix_objects.h"
#include "force.h"
#include "neigh_list.h"
#include "pair.h"

using namespace LAMMPS_NS;

namespace {

/// `object` is the tag of its hub; `partner` is that of the other's hub, or of an atom that is no point: tags are unique.
struct Touch {
  int object, partner;
  auto operator<=>(const Touch &) const = default;
};

class Search {
 public:
  Search(LAMMPS *lmp, const FixObjects &objects) : atom_(*lmp->atom), objects_(objects), list_(lmp->force->pair ? lmp->force->pair->list : nullptr) {}

  /// With both sides of each pair that this rank knows. Points without a sphere are not in the list.
  std::vector<Touch> touches() const
  {
    std::vector<Touch> found;
    for (int k = 0; list_ && k < list_->inum; k++) {
      const int i = list_->ilist[k];
      for (int n = 0; n < list_->numneigh[i]; n++) {
        const int j = list_->firstneigh[i][n] & NEIGHMASK;
        if (!touch(i, j)) continue;
        const int a = party(i), b = party(j);
        if (a == b) continue;
        if (objects_.is_point(i)) found.push_back({a, b});
        if (objects_.is_point(j)) found.push_back({b, a});
      }
    }
    return found;
  }

 private:
  int party(int i) const { return objects_.is_point(i) ? objects_.tag_of_hub(i) : atom_.tag[i]; }
  bool touch(int i, int j) const
  {
    double distance_squared = 0.0;
    for (int d = 0; d < 3; d++) distance_squared += (atom_.x[i][d] - atom_.x[j][d]) * (atom_.x[i][d] - atom_.x[j][d]);
    const double reach = atom_.radius[i] + atom_.radius[j];
    return distance_squared < reach * reach;
  }

  const Atom &atom_;
  const FixObjects &objects_;
  const NeighList *list_;
};

}  // namespace

ContactPartners::ContactPartners(LAMMPS *lmp) : lmp_(lmp)
{
  const FixObjects *objects = find_objects(lmp);
  if (!objects) return;
  Atom *atom = lmp->atom;
  std::vector<Touch> here, elsewhere;
  for (const Touch &touch : Search(lmp, *objects).touches()) {
    const int hub = atom->map(touch.object);
    (hub >= 0 && hub < atom->nlocal ? here : elsewhere).push_back(touch);
  }
  const auto without_repeats = [](std::vector<Touch> &touches) {
    std::sort(touches.begin(), touches.end());
    touches.erase(std::unique(touches.begin(), touches.end()), touches.end());
  };
  without_repeats(elsewhere);
  elsewhere = from_all_ranks(elsewhere, lmp->world);
  here.insert(here.end(), elsewhere.begin(), elsewhere.end());
  without_repeats(here);
  for (const Touch &touch : here) number_[touch.object]++;
}

int ContactPartners::of(const swellflow::ObjectPoints &object) const
{
  const auto found = number_.find(lmp_->atom->tag[object.hub]);
  return found == number_.end() ? 0 : found->second;
}
