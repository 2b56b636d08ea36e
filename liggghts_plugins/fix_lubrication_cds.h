// The part of the lubrication force between discs, and between discs and the walls of the box, that the fluid's grid does not resolve.
#pragma once

#include <string>
#include <vector>

#include "fix.h"
#include "fluid_partner.h"
#include "objects/lubrication.h"
#include "objects/vector2.h"

namespace LAMMPS_NS {

class FixObjects;

/// The rank that owns an object's hub finds the force on the object; each rank adds to its own points their share of it. Both ranks of a pair reckon with the same numbers.
class FixLubricationCds : public Fix {
 public:
  FixLubricationCds(class LAMMPS *, int, char **);

  int setmask() override;
  void post_create() override;
  void init() override;
  void setup(int) override;
  void post_force(int) override;
  double compute_vector(int) override;
  int pack_comm(int n, int *list, double *buf, int pbc_flag, int *pbc) override;
  void unpack_comm(int n, int first, double *buf) override;
  double extend_cut_ghost() override;

  /// Adds, two values an own atom, what this fix has put into atom->f in this step.
  void add_given(double *own_xy) const;

 private:
  enum Value { GAPS, SMALLEST_GAP, POWER, N_VALUES };
  /// An object as a disc; stored with its hub.
  struct Disc {
    double from_hub[2], velocity[2], radius, inverse_mass;
  };
  static constexpr int DISC_SIZE = sizeof(Disc) / sizeof(double);
  static constexpr int WALL = -1;
  /// Of a disc whose hub is an own atom to what is in reach.
  struct Gap {
    int hub, other;           // own atom; own atom or ghost, or WALL
    swellflow::Vector2 ahead; // direction from the disc to the other
    double width, resistance, approach;
  };

  bool acts_on(const swellflow::ObjectPoints &object) const;
  bool is_moved_as_told(int i) const;
  void require_discs();
  template <typename Visit>
  void for_each_member(const swellflow::ObjectPoints &object, const Visit &visit) const;
  void measure_discs();
  swellflow::Vector2 centre(int hub) const;
  swellflow::Vector2 velocity(int hub) const;
  void find_gaps();
  void find_gaps_of_pairs();
  void add_gap(int hub, int other, const swellflow::Vector2 &way);
  void find_gaps_to_walls(int hub);
  double missing_at_side(int side, double radius, double gap) const;
  void make_resistances_implicit();
  void share_forces();

  swellflow::LubricationLaw law_;
  FixObjects *objects_ = nullptr;
  int groups_moved_as_told_ = 0;
  std::vector<Disc> discs_;    // by atom, own and ghosts; of hubs only
  std::vector<Gap> gaps_;
  std::vector<double> given_;  // to atom->f in this step, two values an own atom
};

}  // namespace LAMMPS_NS
