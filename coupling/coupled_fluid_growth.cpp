// Objects that swell and do not drink: the fluid inside grows with them, and as much is pushed out of the box.
#include "coupling/coupled_fluid.h"
#include "coupling/growth_sources.h"
#include "coupling/stopwatch.h"
#include "liggghts_plugins/fix_objects.h"
#include "liggghts_plugins/fluid_columns.h"
#include "liggghts_plugins/objects/outline.h"

namespace swellflow {

using Topology = LAMMPS_NS::FixObjects;

/// An object that begins to inflate has as much fluid inside as its outline holds.
template <int Dim> void CoupledFluid<Dim>::note_inflating(const std::vector<ObjectPoints> &objects)
{
  for (std::size_t n = 0; n < objects.size(); ++n) {
    const int hub = points_.own_index(objects[n].hub);
    if (hub < 0) continue;
    double *state = points_.state[hub];
    if (!objects[n].inflates) {
      state[FluidState::INNER_AREA] = 0.0;
      continue;
    }
    if (state[FluidState::INNER_AREA] == 0.0) state[FluidState::INNER_AREA] = outline_shape(points_.outline(objects[n])).area;
    state[FluidState::FILLED] = described_[n].filled;
  }
}

/// By how much the rate q = (dA/dt) / (2A) of the area inside the outline is more than what the markers' own velocities make, per area inside them. None where markers fill the inside: sources
/// are everywhere, then.
template <int Dim> double CoupledFluid<Dim>::excess_growth(const ObjectPoints &object) const
{
  if (!object.inflates || described_.back().filled) return 0.0;
  return ring_.dilation_rate() * (outline_shape(points_.outline(object)).area / ring_.area() - 1.0);
}

/// Sources where objects have grown in this step: the flow inside has to grow with the area of the outline, as far as that goes towards the natural one, so that what leaves the box is what the
/// outline truly gains, contact or not; what is pressed smaller the fluid inside resists. The rank of an object's hub sends them to the slabs.
template <int Dim> void CoupledFluid<Dim>::grow_inside(const std::vector<ObjectPoints> &objects)
{
  Stopwatch watch(seconds_in_coupling_);
  leaving_sources_.clear();
  to_.clear();
  for (const ObjectPoints &object : objects) {
    const int hub = points_.own_index(object.hub);
    if (!object.inflates || hub < 0) continue;
    const double *point = points_.object_point[hub], lambda = points_.object_size[hub][Topology::LAMBDA];
    const std::vector<Vector2> outline = points_.outline(object);
    double &inside = points_.state[hub][FluidState::INNER_AREA];
    const double now = followed_area(inside, outline_shape(outline).area, lambda * lambda * point[Topology::NATURAL_AREA]);
    const double rate = (now - inside) / dt_;
    inside = now;
    if (rate == 0.0 || !std::isfinite(rate)) continue;
    const std::size_t first = leaving_sources_.size();
    const double depth = points_.state[hub][FluidState::FILLED] != 0.0 ? 0.0 : source_depth * flow_.grid().h;
    add_source_points(shrunk(outline, depth), {points_.x[object.hub][0], points_.x[object.hub][1]}, flow_.grid().h, leaving_sources_);
    for (std::size_t p = first; p < leaving_sources_.size(); ++p) {
      leaving_sources_[p].share *= rate;
      to_.push_back(slab_of(leaving_sources_[p].x));
    }
  }
  to_sources_.deliver(leaving_sources_, to_, arrived_sources_);
  CellSources<Dim> &sources = flow_.sources();
  sources.clear();
  for (const SourcePoint &source : arrived_sources_) sources.add(source.x, source.share);
  sources.complete();
}

template void CoupledFluid<2>::note_inflating(const std::vector<ObjectPoints> &);
template double CoupledFluid<2>::excess_growth(const ObjectPoints &) const;
template void CoupledFluid<2>::grow_inside(const std::vector<ObjectPoints> &);

}  // namespace swellflow
