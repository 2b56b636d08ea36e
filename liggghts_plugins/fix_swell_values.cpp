// What fix swell shows of its objects in thermo lines.
#include <algorithm>
#include <cmath>

#include "atom.h"
#include "fix_objects.h"
#include "fix_swell.h"
#include "object_geometry.h"
#include "objects/outline.h"
#include "update.h"

using namespace LAMMPS_NS;
using swellflow::ObjectPoints;

void FixSwell::add_object(const ObjectPoints &object, double *sums, double *extremes) const
{
  const double *point = objects_->points()[object.hub];
  const std::vector<swellflow::Vector2> outline = outline_of(lmp, object);
  double distance = 0.0;
  for (const swellflow::Vector2 &vertex : outline) distance += vertex.norm();
  const swellflow::OutlineShape shape = swellflow::outline_shape(outline);
  const double lambda = objects_->sizes()[object.hub][FixObjects::LAMBDA], area_made = point[FixObjects::NATURAL_AREA];
  sums[COUNT] += 1.0;
  sums[NATURAL] += lambda * point[FixObjects::DIAMETER];
  sums[HUB_DISTANCE] += 2.0 * distance / object.n_ring;
  sums[OF_AREA] += swellflow::diameter_of_area(shape.area, area_made, point[FixObjects::DIAMETER]);
  sums[ASPECT_RATIO] += shape.aspect_ratio;
  sums[AREA] += shape.area;
  sums[ELAPSED] += elapsed(point, time());
  extremes[MINUS_AREA_RATIO] = std::max(extremes[MINUS_AREA_RATIO], -shape.area / (lambda * lambda * area_made));
  extremes[LAMBDA_MAX] = std::max(extremes[LAMBDA_MAX], lambda);
}

const double *FixSwell::values()
{
  if (values_step_ == update->ntimestep) return values_;
  double sums[N_SUMS] = {}, extremes[N_EXTREMES] = {-1e300, 0.0};
  const bool current = objects_->current_everywhere();
  for (std::size_t k = 0; current && k < objects_->objects().size(); k++) {
    const ObjectPoints &object = objects_->objects()[k];
    if (objects_->owns(object) && (atom->mask[object.hub] & groupbit)) add_object(object, sums, extremes);
  }
  MPI_Allreduce(MPI_IN_PLACE, sums, N_SUMS, MPI_DOUBLE, MPI_SUM, world);
  MPI_Allreduce(MPI_IN_PLACE, extremes, N_EXTREMES, MPI_DOUBLE, MPI_MAX, world);
  const double n = std::max(sums[COUNT], 1.0), area_ratio = sums[COUNT] > 0.0 ? -extremes[MINUS_AREA_RATIO] : 0.0;
  const double all[N_SIZES] = {sums[NATURAL] / n, sums[HUB_DISTANCE] / n, sums[OF_AREA] / n,    sums[ASPECT_RATIO] / n, area_ratio,
                                sums[AREA],        extremes[LAMBDA_MAX],   time(),               sums[ELAPSED] / n};
  std::copy(all, all + N_SIZES, values_);
  values_step_ = update->ntimestep;
  return values_;
}

double FixSwell::compute_scalar() { return values()[0]; }

double FixSwell::compute_vector(int n)
{
  if (n < N_SIZES) return values()[n];
  return n == N_SIZES ? pace_now().against_flow() : pace_now().against_contacts();
}
