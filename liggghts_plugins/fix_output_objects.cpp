#include "fix_output_objects.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "all_ranks.h"
#include "atom.h"
#include "collective.h"
#include "comm.h"
#include "contact_forces.h"
#include "error.h"
#include "fix_objects.h"
#include "group.h"
#include "modify.h"
#include "object_measures.h"
#include "options.h"
#include "update.h"

using namespace LAMMPS_NS;
using swellflow::MeasureTotals;
using swellflow::ObjectMeasures;

namespace {

std::vector<int> ids_or_all(swellflow::Arguments &words)
{
  std::vector<int> ids;
  if (!words.next_is_number()) {
    words.choice("objects", {"all"});
    return ids;
  }
  while (words.next_is_number()) ids.push_back(words.integer("objects", swellflow::Range::at_least(1)));
  return ids;
}

}  // namespace

/* ---------------------------------------------------------------------- */

FixOutputObjects::FixOutputObjects(LAMMPS *lmp, int narg, char **arg) : Fix(lmp, narg, arg), begun_(false), times_(lmp), values_{}, values_step_(-1)
{
  swellflow::or_stop(lmp, [&] {
    swellflow::Arguments line(std::string("fix ") + id + " output/objects", narg - 3, arg + 3);
    swellflow::Options options(line.place());
    options.integer("every", nevery, swellflow::Range::at_least(1), "DEM steps between measurements").required();
    options.text("file", file_name_, "file of comma-separated values; its folder is made when it is missing");
    options.custom("objects", [this](swellflow::Arguments &words) { chosen_ = ids_or_all(words); }, "all, or ids (molecules) of the group's objects");
    options.parse(line);
  });
  restart_global = 1;
  scalar_flag = vector_flag = 1;
  size_vector = N_VALUES;
  global_freq = nevery;
  extscalar = extvector = 0;
  if (has_file()) open_file();
}

int FixOutputObjects::setmask() { return FixConst::END_OF_STEP; }

void FixOutputObjects::post_create() { require_objects(lmp, *this); }

void FixOutputObjects::fail(const std::string &message) { error->fix_error(FLERR, this, message.c_str()); }

void FixOutputObjects::open_file()
{
  require_own_file();
  try {
    swellflow::on_rank_0(world, [this] { file_ = std::make_unique<swellflow::MeasureFile>(file_name_, swellflow::unit_names(update->unit_style)); });
  } catch (const std::runtime_error &failure) {
    fail(failure.what());
  }
}

void FixOutputObjects::require_own_file()
{
  for (int k = 0; k < modify->nfix; k++) {
    const auto *other = dynamic_cast<const FixOutputObjects *>(modify->fix[k]);
    if (!other || std::string(other->id) == id || other->file_name_ != file_name_) continue;
    fail("each output needs a file of its own, but fix " + std::string(other->id) + " writes into '" + file_name_ + "' already: name another");
  }
}

void FixOutputObjects::init()
{
  require_objects(lmp, *this);
  if (has_file()) require_whole_forces(lmp, *this);
  values_step_ = -1;
}

/* ---------------------------------------------------------------------- */

void FixOutputObjects::setup(int)
{
  find_objects(lmp)->require_whole_objects(*this);
  require_chosen_objects();
  if (times_.begin_run(nevery) && has_file()) write_lines();
}

void FixOutputObjects::require_chosen_objects()
{
  if (chosen_.empty()) return;
  const FixObjects *objects = find_objects(lmp);
  std::vector<int> present;
  for (const auto &object : objects->objects())
    if (objects->owns(object) && (atom->mask[object.hub] & groupbit)) present.push_back(atom->molecule[object.hub]);
  present = from_all_ranks(present, world);
  for (int wanted : chosen_)
    if (std::find(present.begin(), present.end(), wanted) == present.end())
      fail("'objects' must name objects of the group, but group '" + std::string(group->names[igroup]) + "' has no object (molecule) " +
           std::to_string(wanted) + ": change it");
}

void FixOutputObjects::end_of_step()
{
  values_step_ = -1;  // a variable may have asked for the values of this step before its forces were whole
  if (has_file()) write_lines();
}

std::vector<ObjectMeasures> FixOutputObjects::chosen_objects() const
{
  std::vector<ObjectMeasures> objects = measure_objects(lmp, groupbit);
  if (!chosen_.empty())
    std::erase_if(objects, [this](const ObjectMeasures &object) { return std::find(chosen_.begin(), chosen_.end(), object.id) == chosen_.end(); });
  return objects;
}

void FixOutputObjects::write_lines()
{
  if (!times_.take_step()) return;
  const std::vector<ObjectMeasures> objects = from_all_ranks(chosen_objects(), world);
  try {
    swellflow::on_rank_0(world, [&] {
      if (!begun_) file_->begin(times_.own_from());
      file_->append(update->ntimestep, times_.time(), objects);
    });
  } catch (const std::runtime_error &failure) {
    fail(failure.what());
  }
  begun_ = true;
}

void FixOutputObjects::write_restart(FILE *fp) { times_.write_restart(fp); }

void FixOutputObjects::restart(char *buffer) { times_.restart(buffer); }

/* ----------------------------------------------------------------------
   values for thermo
------------------------------------------------------------------------- */

const std::array<double, FixOutputObjects::N_VALUES> &FixOutputObjects::values()
{
  if (values_step_ == update->ntimestep) return values_;
  const std::vector<ObjectMeasures> objects = chosen_objects();
  MeasureTotals all(objects);
  MPI_Allreduce(MPI_IN_PLACE, all.sum.data(), all.sum.size(), MPI_DOUBLE, MPI_SUM, world);
  MPI_Allreduce(MPI_IN_PLACE, all.largest.data(), all.largest.size(), MPI_DOUBLE, MPI_MAX, world);
  const double mean_diameter = all.mean(MeasureTotals::DIAMETER);
  double spread = 0.0;
  for (const ObjectMeasures &object : objects) spread += std::pow(object.mean_diameter - mean_diameter, 2);
  MPI_Allreduce(MPI_IN_PLACE, &spread, 1, MPI_DOUBLE, MPI_SUM, world);
  using T = MeasureTotals;
  values_ = {all.number(), mean_diameter, all.mean(T::DIAMETER_OF_AREA), std::sqrt(spread / std::max(all.number(), 1.0)), all.sum[T::AREA],
             all.mean(T::ASPECT_RATIO), 0.0 - all.largest_or_0(T::MINUS_AREA_RATIO), all.sum[T::SPRING_ENERGY], all.sum[T::KINETIC_ENERGY],
             all.mean(T::PRESSURE), all.largest_or_0(T::LARGEST_PRESSURE), all.sum[T::FORCE], all.mean(T::COORDINATION), all.mean(T::ROTATION),
             all.largest_or_0(T::LARGEST_ROTATION), all.mean(T::VELOCITY_X), all.mean(T::VELOCITY_Y), all.mean(T::HEIGHT)};
  values_step_ = update->ntimestep;
  return values_;
}

double FixOutputObjects::compute_scalar() { return values()[0]; }

double FixOutputObjects::compute_vector(int n) { return values()[n]; }
