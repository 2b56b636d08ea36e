// How far objects have turned since they were made.
#include <vector>

#include "atom.h"
#include "fix_objects.h"
#include "object_geometry.h"
#include "objects/orientation.h"

using namespace LAMMPS_NS;
using swellflow::Vector2;

namespace {

/// What best_fit_angle() asks for, of one object after the other.
struct Posture {
  std::vector<Vector2> rest, now;
  std::vector<double> mass;

  void take(const swellflow::ObjectPoints &object, const Atom &atom, double **points)
  {
    rest.clear(), now.clear(), mass.clear();
    Vector2 centre = Vector2::Zero();
    double whole = 0.0;
    for_each_point(object, [&](int i) {
      rest.emplace_back(points[i][FixObjects::REST_X], points[i][FixObjects::REST_Y]);
      now.emplace_back(atom.x[i][0] - atom.x[object.hub][0], atom.x[i][1] - atom.x[object.hub][1]);
      mass.push_back(atom.rmass[i]);
      centre += mass.back() * now.back();
      whole += mass.back();
    });
    for (Vector2 &r : now) r -= centre / whole;
  }
};

}  // namespace

void FixObjects::update_rotations()
{
  Posture posture;
  for (const swellflow::ObjectPoints &object : objects_) {
    posture.take(object, *atom, points());
    const double angle = swellflow::unwrapped_angle(swellflow::best_fit_angle(posture.rest, posture.now, posture.mass), points()[object.hub][ROTATION]);
    for_each_point(object, [&](int i) {
      points()[i][ROTATION] = angle;
      if (const int own = own_index(i); own >= 0) points()[own][ROTATION] = angle;
    });
  }
}
