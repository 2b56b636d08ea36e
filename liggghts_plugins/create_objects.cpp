#include "create_objects.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <numbers>
#include <sstream>

#include "atom.h"
#include "atom_vec.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "fix_objects.h"
#include "modify.h"
#include "objects/outline.h"
#include "options.h"

using namespace LAMMPS_NS;
using swellflow::shown;
using swellflow::Vector2;

namespace {

std::string position(const Vector2 &x) { return "(" + shown(x.x()) + ", " + shown(x.y()) + ")"; }

}  // namespace

void CreateObjects::command(int narg, char **arg)
{
  swellflow::or_stop(lmp, [&] {
    require_settings();
    objects_ = swellflow::read_object_list(narg, arg, [this](const std::string &name) { return whole_file(name); });
    for (const auto &object : objects_) check_place(object);
    check_overlap();
  });
  create();
}

void CreateObjects::require_settings() const
{
  const std::string problem = why_no_objects(lmp);
  if (!problem.empty()) throw swellflow::OptionError("create_objects: " + problem);
  if (modify->nfix_restart_peratom)
    throw swellflow::OptionError("create_objects: objects can be added to those of a restart file only after a run: add 'run 0' above");
}

/* ----------------------------------------------------------------------
   one rank reads, so that all see the same text
------------------------------------------------------------------------- */

std::string CreateObjects::whole_file(const std::string &name) const
{
  std::string text;
  int size = -1;
  if (comm->me == 0) {
    std::ifstream file(name);
    std::ostringstream contents;
    if (file) {
      contents << file.rdbuf();
      text = contents.str();
      size = static_cast<int>(text.size());
    }
  }
  MPI_Bcast(&size, 1, MPI_INT, 0, world);
  if (size < 0) throw swellflow::OptionError("create_objects file: the file must be readable, but '" + name + "' is not: correct the name");
  text.resize(size);
  MPI_Bcast(text.data(), size, MPI_CHAR, 0, world);
  return text;
}

/* ---------------------------------------------------------------------- */

swellflow::PlaneBox CreateObjects::box() const
{
  return {.low = {domain->boxlo[0], domain->boxlo[1]},
          .high = {domain->boxhi[0], domain->boxhi[1]},
          .periodic = {domain->xperiodic != 0, domain->yperiodic != 0}};
}

void CreateObjects::check_place(const swellflow::NewObject &object) const
{
  const auto fail = [&](const std::string &message) { throw swellflow::OptionError(object.place + ": " + message); };
  if (object.type > atom->ntypes)
    fail("'type' must be one of the box's " + std::to_string(atom->ntypes) + " atom types, but is " + std::to_string(object.type) +
         ": change it, or the number in create_box");
  const swellflow::PlaneBox whole = box();
  const double diameter = object.disk.diameter;
  for (int d = 0; d < 2; d++) {
    const double low = whole.low[d], high = whole.high[d], at = object.centre[d];
    const std::string ends = shown(low) + " to " + shown(high) + " in " + "xy"[d];
    if (whole.periodic[d] && (diameter >= 0.5 * (high - low) || at < low || at >= high))
      fail("an object must have its centre in a periodic box at least twice its size, but the one at " + position(object.centre) +
           " with diameter " + shown(diameter) + " has not, in the box from " + ends + ": move it, or make the box larger");
    if (!whole.periodic[d] && (at - 0.5 * diameter <= low || at + 0.5 * diameter >= high))
      fail("an object must lie inside the box and not touch its sides, but the one at " + position(object.centre) + " with diameter " + shown(diameter) +
           " touches or leaves the box from " + ends + ": move it, or make the box larger");
  }
}

void CreateObjects::check_overlap() const
{
  std::vector<swellflow::Circle> circles = existing_circles();
  const int first_new = circles.size();
  const swellflow::PlaneBox whole = box();
  for (const auto &object : objects_) circles.push_back({object.centre, 0.5 * object.disk.diameter});
  const auto place = [&](int k) { return position(circles[k].centre); };
  if (const auto overlap = swellflow::deepest_overlap(circles, first_new, whole)) {
    const bool with_earlier = overlap->first < first_new;
    throw swellflow::OptionError(objects_[overlap->second - first_new].place + ": objects must not overlap, but the one at " +
                                 place(overlap->second) + " overlaps " + (with_earlier ? "an earlier one at " : "the one at ") +
                                 place(overlap->first) + " by " + swellflow::rounded(overlap->depth) + ": move one, or make it smaller");
  }
  circles.erase(circles.begin(), circles.begin() + first_new);
  for (std::size_t k = 0; k < circles.size(); k++) circles[k].radius += objects_[k].disk.cds_radius();
  if (const auto contact = swellflow::deepest_overlap(circles, 0, whole); contact && comm->me == 0)
    error->warning(FLERR, ("create_objects: contact detection spheres of the objects at " + place(contact->first) + " and " +
                           place(contact->second) + " may touch from the start").c_str());
}

std::vector<swellflow::Circle> CreateObjects::existing_circles() const
{
  std::vector<double> own;
  if (const FixObjects *objects = find_objects(lmp))
    for (int i = 0; i < atom->nlocal; i++) {
      const double *point = objects->points()[i];
      if (objects->is_point(i) && point[FixObjects::INDEX] < 0.0)
        own.insert(own.end(), {atom->x[i][0], atom->x[i][1], 0.5 * point[FixObjects::LAMBDA] * point[FixObjects::DIAMETER]});
    }
  int size = own.size();
  std::vector<int> sizes(comm->nprocs), offsets(comm->nprocs, 0);
  MPI_Allgather(&size, 1, MPI_INT, sizes.data(), 1, MPI_INT, world);
  for (int rank = 1; rank < comm->nprocs; rank++) offsets[rank] = offsets[rank - 1] + sizes[rank - 1];
  std::vector<double> all(offsets.back() + sizes.back());
  MPI_Allgatherv(own.data(), size, MPI_DOUBLE, all.data(), sizes.data(), offsets.data(), MPI_DOUBLE, world);
  std::vector<swellflow::Circle> circles;
  for (std::size_t k = 0; k < all.size(); k += 3) circles.push_back({{all[k], all[k + 1]}, all[k + 2]});
  return circles;
}

/* ---------------------------------------------------------------------- */

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
    for (int index = -1; index < objects_[k].disk.ring_points; index++) create_point(k, index, tag++, last[1] + 1 + k);
  for (int k = 0; k < modify->nfix; k++) {
    Fix *fix = modify->fix[k];
    if (!fix->create_attribute) continue;
    fix->pre_set_arrays();
    for (int i = first; i < atom->nlocal; i++) fix->set_arrays(i);
  }
  describe_points(first);
  publish(tag - first_tag);
}

/* ----------------------------------------------------------------------
   only on the rank whose part of the box the point lies in
------------------------------------------------------------------------- */

void CreateObjects::create_point(int object, int index, int tag, int molecule)
{
  const swellflow::Disk &disk = objects_[object].disk;
  const Vector2 centre = objects_[object].centre, at = index < 0 ? centre : Vector2(centre + disk.ring_point(index));
  const bool zero_is_inside = domain->boxlo[2] <= 0.0 && domain->boxhi[2] > 0.0;
  double x[3] = {at.x(), at.y(), zero_is_inside ? 0.0 : 0.5 * (domain->boxlo[2] + domain->boxhi[2])};
  tagint image = (static_cast<tagint>(IMGMAX) << IMG2BITS) | (static_cast<tagint>(IMGMAX) << IMGBITS) | IMGMAX;
  domain->remap(x, image);
  for (int d = 0; d < 3; d++)
    if (x[d] < domain->sublo[d] || x[d] >= domain->subhi[d]) return;

  atom->avec->create_atom(objects_[object].type, x);
  const int i = atom->nlocal - 1;
  atom->tag[i] = tag;
  atom->image[i] = image;
  atom->molecule[i] = molecule;
  atom->radius[i] = disk.cds_radius();
  atom->rmass[i] = index < 0 ? disk.hub_mass() : disk.ring_point_mass();
  // LIGGGHTS' own relation for a disc holds between the three, also while an object swells.
  if (atom->density) atom->density[i] = atom->rmass[i] / (std::numbers::pi * atom->radius[i] * atom->radius[i]);
  own_points_.push_back({object, index});
}

void CreateObjects::describe_points(int first) const
{
  double **points = find_objects(lmp)->points();
  for (std::size_t k = 0; k < own_points_.size(); k++) {
    const auto &[object, index] = own_points_[k];
    const swellflow::Disk &disk = objects_[object].disk;
    const int i = first + static_cast<int>(k);
    double *point = points[i];
    point[FixObjects::RING_POINTS] = disk.ring_points;
    point[FixObjects::INDEX] = index;
    point[FixObjects::DIAMETER] = disk.diameter;
    point[FixObjects::NATURAL_AREA] = swellflow::regular_polygon_area(disk.ring_points, disk.diameter);
    point[FixObjects::SPOKES] = 1.0;
    point[FixObjects::SPOKE_LENGTH] = index < 0 ? 0.0 : disk.spoke_length();
    point[FixObjects::RING_LENGTH] = index < 0 ? 0.0 : disk.ring_spring_length();
    const Vector2 rest = index < 0 ? Vector2(Vector2::Zero()) : disk.ring_point(index);
    point[FixObjects::REST_X] = rest.x();
    point[FixObjects::REST_Y] = rest.y();
    point[FixObjects::CDS_RADIUS] = atom->radius[i];
    point[FixObjects::HAS_CDS] = 1.0;
    point[FixObjects::MASS] = atom->rmass[i];
    point[FixObjects::LAMBDA] = 1.0;
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
    if (out) fprintf(out, "Created %d objects with %d points\n", static_cast<int>(objects_.size()), n_points);
}
