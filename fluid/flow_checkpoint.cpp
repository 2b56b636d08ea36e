// What a flow is between two steps: all that the next step reads, and what is told of the last one.
#include "fluid/checkpoint.h"
#include "fluid/flow_solver.h"
#include "fluid/scalar_transport.h"

namespace swellflow {

namespace {

std::string numbered(const std::string &name, int i) { return name + " " + std::to_string(i); }

}  // namespace

/// Where the end is known, the beginning of the next step is.
template <int Dim> void BoundaryValues<Dim>::keep(Checkpoint &file)
{
  const int last = Grid<Dim>::last;
  for (int side = 0; side < 2 * Dim; ++side) {
    if (boundaries_.kind[side] == Boundary::periodic) continue;
    for (int c = 0; c < Dim; ++c) {
      std::vector<double> &values = present_[side][c];
      const bool across = side / 2 == last;
      std::size_t size = 1;
      for (int d = 0; d < last; ++d)
        if (d != side / 2) size *= layout_.cells(d);
      const Checkpoint::Part part = across ? Checkpoint::Part{is_here(side) ? 0 : 1, is_here(side), 1, size}
                                           : Checkpoint::Part{grid_.first_plane, grid_.planes, grid_.cells[last], size};
      file.array(numbered(numbered("velocity on side", side), c), values.data(), part);
    }
  }
  file.number("source let out", source_);
  if (file.loads()) next_ = present_;
}

template <int Dim> void SideImpulses<Dim>::keep(Checkpoint &file)
{
  for (int side = 0; side < 2 * Dim; ++side) {
    file.parts(numbered("impulse of side", side), impulse_[side].data(), Dim);
    file.parts(numbered("carried through side", side), carried_[side].data(), Dim);
  }
  file.parts("outflow through sides", &outflow_, 1);
}

template <int Dim> void CellSources<Dim>::keep(Checkpoint &file)
{
  file.planes("sources", rate_, grid_, layout_);
  file.number("sum of sources", total_);
}

template <int Dim> void FlowSolver<Dim>::keep(Checkpoint &file)
{
  for (int c = 0; c < Dim; ++c) {
    file.planes(numbered("velocity", c), u_[c], grid_, layout_);
    file.planes(numbered("face velocity", c), face_velocity_[c], grid_, layout_, true);
    file.planes(numbered("advection", c), advection_[c], grid_, layout_);
  }
  file.planes("pressure over density", p_, grid_, layout_);
  sides_.keep(file);
  side_impulses_.keep(file);
  bool has_sources = sources_.has_value();
  file.flag("has sources", has_sources);
  if (has_sources && !sources_) sources_.emplace(grid_, layout_);
  if (has_sources) sources_->keep(file);
  file.common("body force", body_force_.data(), Dim);
  file.parts("impulse of sources", source_impulse_.data(), Dim);
  file.parts("momentum of sources", source_momentum_.data(), Dim);
  file.number("flow step", dt_);
  file.number("flow step before", dt_before_);
  if (file.loads()) face_velocity_around();
}

template <int Dim> void ScalarTransport<Dim>::keep(Checkpoint &file, const std::string &name)
{
  file.planes("scalar " + name, c_, grid_, layout_);
  for (int c = 0; c < Dim; ++c) file.planes(numbered("carrier of " + name, c), carrier_[c], grid_, layout_, true);
  file.flag("carrier known of " + name, knows_faces_before_);
  double parts[] = {budget_.entered, budget_.left, budget_.appeared, budget_.withdrawn};
  file.parts("budget of " + name, parts, 4);
  budget_ = {.entered = parts[0], .left = parts[1], .appeared = parts[2], .withdrawn = parts[3]};
  double sub_steps = sub_steps_;
  file.number("sub-steps of " + name, sub_steps);
  sub_steps_ = static_cast<int>(sub_steps);
  if (!file.loads()) return;
  for (int c = 0; c < Dim; ++c) {
    halo_.wrap(carrier_[c], Grid<Dim>::ghost);
    halo_.fill(carrier_[c], Grid<Dim>::ghost);
  }
}

template void BoundaryValues<2>::keep(Checkpoint &);
template void SideImpulses<2>::keep(Checkpoint &);
template void CellSources<2>::keep(Checkpoint &);
template void FlowSolver<2>::keep(Checkpoint &);
template void ScalarTransport<2>::keep(Checkpoint &, const std::string &);

}  // namespace swellflow
