#include "create_objects.h"

#include <algorithm>
#include <numbers>
#include <numeric>

#include "atom.h"
#include "atom_vec.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "fix_objects.h"
#include "modify.h"
#include "options.h"
#include "region_room.h"
#include "text_file.h"

using namespace LAMMPS_NS;
using swellflow::Vector2;

namespace {

/// Radius of a point without a sphere, over that which it would have: LIGGGHTS divides by it, and nothing must touch it.
constexpr double token_radius = 1e-6;

}  // namespace

void CreateObjects::command(int narg, char **arg)
{
  swellflow::or_stop(lmp, [&] {
    require_settings();
    swellflow::ObjectList list = swellflow::read_object_list(narg, arg, scene());
    objects_ = std::move(list.objects);
    remark_ = list.remark;
    overlap_ = list.overlap;
    require_room("create_objects", n_points());
    for (const auto &object : objects_) check_place(object);
    check_overlap();
  });
  create();
}

swellflow::ObjectScene CreateObjects::scene() const
{
  return {.points = points_,
          .text_of_file = [this](const std::string &name) { return text_of_file(lmp, "create_objects", name); },
          .box = [this] { return box(); },
          .region = [this](const std::string &id) { return room_of_region(lmp, id, box()); },
          .existing = [this] { return existing_objects(); },
          .require_room = [this](const std::string &place, double points) { require_room(place, points); }};
}

double CreateObjects::n_points() const
{
  return std::accumulate(objects_.begin(), objects_.end(), 0.0, [](double sum, const auto &object) { return sum + object.shape->ring.size() + 1.0; });
}

void CreateObjects::create()
{
  int last[2] = {0, 0};  // tag and molecule id
  for (int i = 0; i < atom->nlocal; i++) {
    last[0] = std::max(last[0], atom->tag[i]);
    last[1] = std::max(last[1], atom->molecule[i]);
  }
  MPI_Allreduce(MPI_IN_PLACE, last, 2, MPI_INT, MPI_MAX, world);
  make_objects(lmp);

  const int first = atom->nlocal, first_tag = last[0] + 1;
  int tag = first_tag;
  for (int k = 0; k < static_cast<int>(objects_.size()); k++)
    for (int index = -1; index < static_cast<int>(objects_[k].shape->ring.size()); index++) create_point(k, index, tag++, last[1] + 1 + k);
  for (int k = 0; k < modify->nfix; k++) {
    Fix *fix = modify->fix[k];
    if (!fix->create_attribute) continue;
    fix->pre_set_arrays();
    for (int i = first; i < atom->nlocal; i++) fix->set_arrays(i);
  }
  describe_points(first);
  find_objects(lmp)->exclude_points_without_spheres();
  publish(tag - first_tag);
}

/* ----------------------------------------------------------------------
   only on the rank whose part of the box the point lies in
------------------------------------------------------------------------- */

void CreateObjects::create_point(int object, int index, int tag, int molecule)
{
  const swellflow::NewObject &made = objects_[object];
  const swellflow::Shape &shape = *made.shape;
  const Vector2 at = made.centre + made.placed(index < 0 ? shape.hub : shape.ring[index].x);
  const bool zero_is_inside = domain->boxlo[2] <= 0.0 && domain->boxhi[2] > 0.0;
  double x[3] = {at.x(), at.y(), zero_is_inside ? 0.0 : 0.5 * (domain->boxlo[2] + domain->boxhi[2])};
  tagint image = (static_cast<tagint>(IMGMAX) << IMG2BITS) | (static_cast<tagint>(IMGMAX) << IMGBITS) | IMGMAX;
  domain->remap(x, image);
  for (int d = 0; d < 3; d++)
    if (x[d] < domain->sublo[d] || x[d] >= domain->subhi[d]) return;

  atom->avec->create_atom(made.type, x);
  const int i = atom->nlocal - 1;
  atom->tag[i] = tag;
  atom->image[i] = image;
  atom->molecule[i] = molecule;
  const bool has_cds = index < 0 ? shape.hub_has_cds : shape.ring[index].has_cds;
  const double mass = shape.mass(made.diameter, made.density);
  atom->radius[i] = has_cds ? made.cds_radius() : token_radius * made.cds_radius();
  atom->rmass[i] = index < 0 ? shape.hub_mass(mass) : shape.ring_point_mass(index, mass);
  // LIGGGHTS' own relation for a disc holds between the three, also while an object swells.
  if (atom->density) atom->density[i] = atom->rmass[i] / (std::numbers::pi * atom->radius[i] * atom->radius[i]);
  own_points_.push_back({object, index});
}

void CreateObjects::describe_points(int first) const
{
  const FixObjects &known = *find_objects(lmp);
  for (std::size_t k = 0; k < own_points_.size(); k++) {
    const auto &[object, index] = own_points_[k];
    const swellflow::NewObject &made = objects_[object];
    const swellflow::Shape &shape = *made.shape;
    const swellflow::Shape::RingPoint *on_ring = index < 0 ? nullptr : &shape.ring[index];
    const int i = first + static_cast<int>(k);
    double *point = known.points()[i], *size = known.sizes()[i];
    point[FixObjects::RING_POINTS] = static_cast<double>(shape.ring.size());
    point[FixObjects::INDEX] = index;
    point[FixObjects::DIAMETER] = made.diameter;
    point[FixObjects::NATURAL_AREA] = shape.natural_area(made.diameter);
    point[FixObjects::MEAN_SQUARE_RADIUS] = made.diameter * made.diameter * shape.mean_square_radius;
    point[FixObjects::SPOKES] = shape.spokes;
    point[FixObjects::SPOKE_LENGTH] = on_ring ? made.diameter * on_ring->spoke_length : 0.0;
    point[on_ring ? FixObjects::RING_LENGTH : FixObjects::LONGEST_SIDE] = made.diameter * (on_ring ? on_ring->ring_length : shape.longest_side());
    const Vector2 rest = made.placed((on_ring ? on_ring->x : shape.hub) - shape.centre_of_mass);
    point[FixObjects::REST_X] = rest.x();
    point[FixObjects::REST_Y] = rest.y();
    point[FixObjects::OUTLINE_OFFSET] = on_ring ? made.diameter * on_ring->outline_offset : 0.0;
    size[FixObjects::CDS_RADIUS] = atom->radius[i];
    point[FixObjects::HAS_CDS] = on_ring ? on_ring->has_cds : shape.hub_has_cds;
    size[FixObjects::MASS] = atom->rmass[i];
    point[FixObjects::OBJECT_MASS] = shape.mass(made.diameter, made.density);
    size[FixObjects::LAMBDA] = 1.0;
  }
}

/* ----------------------------------------------------------------------
   LIGGGHTS learns that there are more atoms
------------------------------------------------------------------------- */

void CreateObjects::publish(int n_points) const
{
  const bigint natoms_before = atom->natoms;
  bigint nlocal = atom->nlocal;
  MPI_Allreduce(&nlocal, &atom->natoms, 1, MPI_LMP_BIGINT, MPI_SUM, world);
  if (atom->natoms - natoms_before != n_points)
    error->all(FLERR, ("create_objects: all " + std::to_string(n_points) + " points must find a rank, but " +
                       std::to_string(atom->natoms - natoms_before) + " did: check the box and the processors line").c_str());
  atom->nghost = 0;
  atom->map_init();
  atom->map_set();
  if (comm->me != 0) return;
  for (FILE *out : {screen, logfile})
    if (out) fprintf(out, "Created %d objects with %d points%s\n", static_cast<int>(objects_.size()), n_points, remark_.c_str());
}
