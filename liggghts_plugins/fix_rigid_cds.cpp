#include "fix_rigid_cds.h"

#include "fix_objects.h"
#include "objects/rigid_motion.h"
#include "options.h"
#include "update.h"

using namespace LAMMPS_NS;

FixRigidCds::FixRigidCds(LAMMPS *lmp, int narg, char **arg) : FixObjectIntegrator(lmp, narg, arg)
{
  swellflow::or_stop(lmp, [&] {
    swellflow::Arguments line(std::string("fix ") + id + " rigid/cds", narg - 3, arg + 3);
    swellflow::Options options(line.place());
    declare_spin(options);
    options.parse(line);
  });
}

void FixRigidCds::move(const swellflow::ObjectPoints &object, swellflow::PointBody &body, const std::vector<swellflow::Vector2> &)
{
  rest_.resize(body.size());
  const double lambda = objects()->sizes()[object.hub][FixObjects::LAMBDA];
  for (int n = 0; n < body.size(); n++) {
    const double *point = objects()->points()[n < object.n_ring ? object.ring[n] : object.hub];
    rest_[n] = lambda * swellflow::Vector2(point[FixObjects::REST_X], point[FixObjects::REST_Y]);
  }
  swellflow::move_rigidly(body, rest_, update->dt);
}
