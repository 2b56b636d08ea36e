#include "coupling/coupled_fluid.h"

#include <cmath>
#include <utility>

#include "coupling/initial_flow.h"
#include "coupling/stopwatch.h"
#include "liggghts_plugins/fluid_columns.h"

namespace swellflow {

namespace {

template <int Dim, class T> std::array<T, Dim> first_of(const std::array<T, 3> &triple)
{
  std::array<T, Dim> result;
  std::copy_n(triple.begin(), Dim, result.begin());
  return result;
}

Advection advection_of(const FluidOptions &options)
{
  switch (options.advection) {
    case AdvectionScheme::bounded: return Advection::bounded;
    case AdvectionScheme::none: return Advection::none;
    default: return Advection::central;
  }
}

Boundary boundary_of(SideKind kind)
{
  switch (kind) {
    case SideKind::slip: return Boundary::slip;
    case SideKind::periodic: return Boundary::periodic;
    case SideKind::inflow: return Boundary::inflow;
    case SideKind::parabolic_inflow: return Boundary::parabolic_inflow;
    case SideKind::outflow: return Boundary::outflow;
    default: return Boundary::wall;
  }
}

}  // namespace

template <int Dim>
CoupledFluid<Dim>::CoupledFluid(void *lammps, const FluidOptions &options, const Grid<Dim> &grid, const Boundaries<Dim> &boundaries)
    : flow_(grid, {options.density, options.kinematic_viscosity}, boundaries, advection_of(options)),
      row_sums_(flow_.grid(), flow_.layout()), markers_(make_markers<Dim>(options.kernel, flow_.grid(), flow_.layout())), flow_rate_(first_of<Dim>(options.controlled)), points_(lammps),
      inner_fluid_(options.density), to_slabs_(grid.comm), to_homes_(grid.comm), to_sources_(grid.comm), options_(options)
{
  if (options.forcing == ForcingScheme::implicit) marker_solver_ = std::make_unique<MarkerSolver<Dim>>(flow_.grid(), flow_.layout(), *markers_);
  start(flow_, boundaries, options);
}

// ---- the step --------------------------------------------------------------------------------------------------------------------------------

/// As many as the CFL number of the flow as it is, and of its sides as they will be, allows. The first step has one: nobody knows yet what the sides will do to a fluid
/// at rest. Growth is gradual and waits until it pays: a new length means new factors for the viscous solves.
template <int Dim> int CoupledFluid<Dim>::choose_dem_steps(double dem_dt, const FluidDrive &drive)
{
  const int most = options_.dem_steps_per_fluid_step;
  if (options_.cfl <= 0.0) return most;
  if (dt_ == 0.0) return 1;
  constexpr double pays = 1.2, largest_growth = 1.5;
  double speed = flow_.max_speed_sum();
  for (const Triple &side : drive.side_velocity) speed = std::max(speed, std::abs(side[0]) + std::abs(side[1]) + std::abs(side[2]));
  const double allowed = speed > 0.0 ? options_.cfl * flow_.grid().h / (speed * dem_dt) : most, before = dt_ / dem_dt;
  const int wanted = std::max(1, static_cast<int>(std::min<double>(most, allowed)));
  if (wanted <= before) return wanted;
  if (wanted < pays * before && wanted < most) return std::max(1, static_cast<int>(before + 1e-9));
  return std::min(wanted, static_cast<int>(std::max(before + 1.0, largest_growth * before) + 1e-9));
}

template <int Dim> void CoupledFluid<Dim>::begin_step(const std::vector<ObjectPoints> &objects, const FluidDrive &drive, int dem_steps)
{
  loaded_.reset();
  points_.refresh();
  dt_before_ = dt_;
  dem_steps_ = dem_steps;
  dt_ = dem_steps * points_.time_step();
  this->drive(drive);
  some_inflate_ = some_inflate_ || drive.some_inflate;
  describe_markers(objects, drive.gravity);
  if (some_inflate_) note_inflating(objects);
  arrive();
  spread_carried();
  given_ = given_to_fluid();
  {
    Stopwatch watch(seconds_in_fluid_);
    flow_.predict_velocity(dt_);
    // Where objects push fluid away, what appears inside them is not known before they have moved.
    // In the first step a projection would turn the initial flow into one that the sides allow, which objects would meet as if it had always been there.
    if (options_.projections > 1 && dt_before_ > 0.0 && !some_inflate_ && some_markers()) flow_.project_prediction(dt_);
  }
  ask_fluid();
  hand_out();
}

template <int Dim> void CoupledFluid<Dim>::complete_law(const std::vector<ObjectPoints> &objects, const FluidDrive &drive)
{
  Stopwatch watch(seconds_in_coupling_);
  for (std::size_t n = 0; n < objects.size(); ++n) {
    inner_fluid_.return_inertia(objects[n], described_[n].motion, described_[n].filled, drive.gravity, dt_, dt_before_, points_);
    inner_pressure_.press(objects[n], 0, points_);
  }
}

template <int Dim> void CoupledFluid<Dim>::press_again(const std::vector<ObjectPoints> &objects, int dem_step)
{
  if (!inner_pressure_.is_due(dem_step)) return;
  Stopwatch watch(seconds_in_coupling_);
  points_.refresh();
  for (const ObjectPoints &object : objects) inner_pressure_.press(object, dem_step, points_);
}

template <int Dim> void CoupledFluid<Dim>::finish_step(const std::vector<ObjectPoints> &objects)
{
  points_.refresh();
  collect(objects);
  force(change_);
  tighten();
  for (int d = 0; d < Dim; ++d) balance_[d] = given_[d] + received_[d] + owed_balance_[d];
  if (some_inflate_) grow_inside(objects);
  {
    Stopwatch watch(seconds_in_fluid_);
    flow_.project(dt_);
  }
  last_dt_ = dt_;
  last_marker_gap_ = marker_gap_;
  last_body_force_ = flow_.body_force();
  note_sides();
  measure_slip();
  agree_on_slip();
}

template <int Dim> bool CoupledFluid<Dim>::some_markers() const
{
  int some = !x_.empty();
  MPI_Allreduce(MPI_IN_PLACE, &some, 1, MPI_INT, MPI_MAX, flow_.grid().comm);
  return some;
}

template <int Dim> void CoupledFluid<Dim>::drive(const FluidDrive &drive)
{
  for (int side = 0; side < 2 * Dim; ++side) flow_.set_side_velocity(side, first_of<Dim>(drive.side_velocity[side]));
  VecD body_force = first_of<Dim>(drive.body_force);
  if (flow_rate_.active()) flow_rate_.update(flow_.mean_velocity(), first_of<Dim>(drive.mean_velocity), dt_, body_force);
  flow_.set_body_force(body_force);
}

// ---- from the points to the slabs ------------------------------------------------------------------------------------------------------------

template <int Dim> void CoupledFluid<Dim>::describe_markers(const std::vector<ObjectPoints> &objects, const Triple &gravity)
{
  Stopwatch watch(seconds_in_coupling_);
  accounts_.clear();
  leaving_.resize(0);
  marker_gap_ = 0.0;
  owed_balance_ = std::exchange(given_late_, VecD{});
  for (int i = 0; i < points_.n_own(); ++i) {
    std::fill_n(points_.law[i], static_cast<int>(FluidLaw::N_COLUMNS), 0.0);
    std::fill_n(points_.impulse[i], static_cast<int>(FluidImpulse::N_COLUMNS), 0.0);
    points_.home[i][FluidHome::HAS_MARKERS] = 0.0;
  }
  described_.clear();
  inner_pressure_.begin(dt_, dem_steps_);
  for (const ObjectPoints &object : objects) describe_object(object, gravity);
}

template <int Dim> void CoupledFluid<Dim>::arrive()
{
  Stopwatch watch(seconds_in_coupling_);
  to_slabs_.deliver(leaving_.x, leaving_.to, x_);
  to_slabs_.deliver_again(leaving_.spacing, spacing_);
  to_slabs_.deliver_again(leaving_.carried, carried_);
  markers_->place(x_);
}

/// And, in the same pass, what comes to each face when all markers are asked for a change by 1.
template <int Dim> void CoupledFluid<Dim>::spread_carried()
{
  Stopwatch watch(seconds_in_coupling_);
  const double per_spacing = options_.density * flow_.grid().h;
  row_sum_.resize(x_.size());
  for (std::size_t l = 0; l < x_.size(); ++l) row_sum_[l].fill(per_spacing * spacing_[l]);
  row_sums_.clear();
  flow_.forcing().clear();
  markers_->spread({{carried_, flow_.forcing()}, {row_sum_, row_sums_}}, options_.density);
  flow_.forcing().complete();
  row_sums_.complete();
}

/// u~ at the markers, and kappa = rho_f ds h / (beta dt). Where markers crowd, their forces overlap: with the kernel's own scale they would overcorrect, and the step be unstable.
template <int Dim> void CoupledFluid<Dim>::ask_fluid()
{
  Stopwatch watch(seconds_in_coupling_);
  markers_->interpolate({{flow_.face_velocity_around(), u_}, {row_sums_.field(), row_sum_}});
  const double per_spacing = options_.density * flow_.grid().h;
  answers_.resize(x_.size());
  for (std::size_t l = 0; l < x_.size(); ++l) {
    const double beta = std::max(markers_->scale(), *std::max_element(row_sum_[l].begin(), row_sum_[l].end()));
    answers_[l] = {u_[l], per_spacing * spacing_[l] / (beta * dt_)};
  }
}

template <int Dim> void CoupledFluid<Dim>::spread(std::span<const VecD> impulses)
{
  Stopwatch watch(seconds_in_coupling_);
  flow_.forcing().clear();
  markers_->spread(impulses, options_.density, flow_.forcing());
  flow_.forcing().complete();
}

template class CoupledFluid<2>;

// ---- the factory -----------------------------------------------------------------------------------------------------------------------------

std::unique_ptr<FluidPartner> make_coupled_fluid(void *lammps, const FluidOptions &options)
{
  const DemEngine engine(lammps);
  const auto low = engine.box_low(), high = engine.box_high();
  const double h = (high[0] - low[0]) / options.cells[0], h_y = (high[1] - low[1]) / options.cells[1];
  if (std::abs(h - h_y) > 1e-9 * h)
    throw std::invalid_argument("the fluid's cells must be square, but 'cells " + std::to_string(options.cells[0]) + " " +
                                std::to_string(options.cells[1]) + "' on a box of " + std::to_string(high[0] - low[0]) + " x " +
                                std::to_string(high[1] - low[1]) + " makes them " + std::to_string(h) + " x " + std::to_string(h_y) +
                                "; choose numbers of cells in the ratio of the box's sides");
  Boundaries<2> boundaries;
  for (int side = 0; side < 4; ++side) {
    boundaries.kind[side] = boundary_of(options.sides[side]);
    boundaries.velocity[side] = first_of<2>(options.initial_side_velocity[side]);
  }
  const Grid<2> grid({options.cells[0], options.cells[1]}, {low[0], low[1]}, h, engine.communicator(), boundaries.periodic());
  return std::make_unique<CoupledFluid<2>>(lammps, options, grid, boundaries);
}

}  // namespace swellflow
