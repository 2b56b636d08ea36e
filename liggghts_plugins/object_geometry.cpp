#include "object_geometry.h"

#include "atom.h"
#include "fix_objects.h"
#include "objects/outline.h"

using namespace LAMMPS_NS;
using swellflow::Vector2;

std::vector<Vector2> LAMMPS_NS::outline_of(LAMMPS *lmp, const swellflow::ObjectPoints &object)
{
  const FixObjects &objects = *find_objects(lmp);
  double **points = objects.points(), **x = lmp->atom->x;
  const double lambda = objects.sizes()[object.hub][FixObjects::LAMBDA];
  const double *hub = x[object.hub];
  std::vector<Vector2> outline(object.n_ring);
  for (int k = 0; k < object.n_ring; k++) {
    const int i = object.ring[k];
    const Vector2 from_hub(x[i][0] - hub[0], x[i][1] - hub[1]);
    outline[k] = swellflow::outline_point(from_hub, lambda * points[i][FixObjects::OUTLINE_OFFSET]);
  }
  return outline;
}
