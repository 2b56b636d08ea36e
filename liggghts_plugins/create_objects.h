// Input command that makes objects in bulk: one, a lattice, a random packing, or a file of them.
#pragma once

#include <string>
#include <vector>

#include "object_list.h"
#include "objects/overlap.h"
#include "pointers.h"

namespace LAMMPS_NS {

class CreateObjects : protected Pointers {
 public:
  /// `points`: on the ring of an object whose line does not say.
  CreateObjects(class LAMMPS *lmp, int points) : Pointers(lmp), points_(points) {}
  void command(int narg, char **arg);

 private:
  /// An atom that this rank made: point `index` (-1 hub) of objects_[object].
  struct OwnPoint {
    int object, index;
  };

  void require_settings() const;
  void require_room(const std::string &place, double points) const;
  void check_place(const swellflow::NewObject &object) const;
  void check_overlap() const;
  void warn_of_contacts(const std::vector<swellflow::Footprint> &footprints) const;
  std::vector<swellflow::ExistingObject> existing_objects() const;
  swellflow::PlaneBox box() const;
  swellflow::ObjectScene scene() const;
  double n_points() const;

  void create();
  void create_point(int object, int index, int tag, int molecule);
  void describe_points(int first) const;
  void publish(int n_points) const;

  int points_;
  std::vector<swellflow::NewObject> objects_;
  std::vector<OwnPoint> own_points_;
  std::string remark_;
  double overlap_ = 0.0;  // by which outlines may
};

}  // namespace LAMMPS_NS
