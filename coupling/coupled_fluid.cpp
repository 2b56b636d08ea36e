#include "coupling/coupled_fluid.h"

#include <cmath>

#include "liggghts_plugins/fix_objects.h"
#include "liggghts_plugins/fluid_columns.h"

namespace swellflow {

namespace {

/// Adds the time of its life to `seconds`.
class Stopwatch {
public:
  explicit Stopwatch(double &seconds) : seconds_(seconds), start_(MPI_Wtime()) {}
  ~Stopwatch() { seconds_ += MPI_Wtime() - start_; }
  Stopwatch(const Stopwatch &) = delete;
  Stopwatch &operator=(const Stopwatch &) = delete;

private:
  double &seconds_;
  double start_;
};

}  // namespace

template <int Dim>
CoupledFluid<Dim>::CoupledFluid(void *lammps, const FluidOptions &options, const Grid<Dim> &grid, const WallVelocities<Dim> &walls)
    : flow_(grid, {options.density, options.kinematic_viscosity}, walls), markers_(flow_.grid(), flow_.layout()), points_(lammps), courier_(grid.comm),
      options_(options)
{
}

// ---- the step --------------------------------------------------------------------------------------------------------------------------------

template <int Dim> void CoupledFluid<Dim>::weigh(const std::vector<ObjectPoints> &objects, const std::array<double, 3> &gravity)
{
  points_.refresh();
  dt_ = options_.dem_steps_per_fluid_step * points_.time_step();
  for (const ObjectPoints &object : objects) return_inner_fluid(object, motion_of(object, points_), gravity);
}

template <int Dim> void CoupledFluid<Dim>::begin_step(const std::vector<ObjectPoints> &objects, const std::array<double, 3> &gravity)
{
  points_.refresh();
  dt_ = options_.dem_steps_per_fluid_step * points_.time_step();
  describe_markers(objects, gravity);
  arrive();
  spread(carried_);
  given_ = given_to_fluid();
  {
    Stopwatch watch(seconds_in_fluid_);
    flow_.predict_velocity(dt_);
  }
  hand_out();
}

template <int Dim> void CoupledFluid<Dim>::finish_step(const std::vector<ObjectPoints> &objects)
{
  points_.refresh();
  collect(objects);
  spread(change_);
  const VecD given = given_to_fluid();
  for (int d = 0; d < Dim; ++d) given_[d] += given[d];
  Stopwatch watch(seconds_in_fluid_);
  flow_.apply_forcing();
  flow_.project(dt_);
}

// ---- from the points to the slabs ------------------------------------------------------------------------------------------------------------

template <int Dim> void CoupledFluid<Dim>::describe_markers(const std::vector<ObjectPoints> &objects, const std::array<double, 3> &gravity)
{
  Stopwatch watch(seconds_in_coupling_);
  own_.clear();
  leaving_.clear();
  to_.clear();
  marker_gap_ = 0.0;
  for (int i = 0; i < points_.n_own(); ++i) {
    std::fill_n(points_.law[i], static_cast<int>(FluidLaw::N_COLUMNS), 0.0);
    std::fill_n(points_.impulse[i], FluidImpulse::N_COLUMNS, 0.0);
  }
  for (const ObjectPoints &object : objects) describe_object(object, gravity);
}

template <int Dim> void CoupledFluid<Dim>::describe_object(const ObjectPoints &object, const std::array<double, 3> &gravity)
{
  const ObjectMotion motion = motion_of(object, points_);
  ring_.place(object, points_, options_.retraction * flow_.grid().h);
  return_inner_fluid(object, motion, gravity);
  const double rate = object.absorbs ? absorption_rate(object) : 0.0;
  for (int k = 0; k < object.n_ring; ++k) describe_marker(object, k, rate);
  remember_motion(object, motion);
}

/// q at which the fluid crosses the outline: as fast as the area inside truly grows, which contact may hold back, and no faster than the natural size does;
/// what is beyond, growth or shrinking, the fluid inside resists.
template <int Dim> double CoupledFluid<Dim>::absorption_rate(const ObjectPoints &object) const
{
  for (int k = -1; k < object.n_ring; ++k) {
    const int i = k < 0 ? object.hub : object.ring[k];
    if (!points_.owns(i)) continue;
    const double *state = points_.state[i];
    if (state[FluidState::KNOWS_BEFORE] == 0.0) return 0.0;
    const double lambda = points_.object_point[i][LAMMPS_NS::FixObjects::LAMBDA];
    const double natural = (lambda - state[FluidState::SWELLING]) / (lambda * dt_);
    return std::clamp(ring_.dilation_rate(object, points_), std::min(0.0, natural), std::max(0.0, natural));
  }
  return 0.0;
}

/// The marker of ring point k: its place and the velocity by which it differs from its point; and the hub's part of the carried force.
template <int Dim> void CoupledFluid<Dim>::describe_marker(const ObjectPoints &object, int k, double absorption_rate)
{
  const int i = object.ring[k], hub = object.hub;
  const Grid<Dim> &grid = flow_.grid();
  const double share = ring_.share(k);
  if (points_.owns(hub))
    for (int d = 0; d < Dim; ++d) points_.law[hub][FluidLaw::A_X + d] -= share * points_.carried[i][d];
  if (!points_.owns(i)) return;

  marker_gap_ = std::max(marker_gap_, ring_.gap(k) / grid.h);
  OwnMarker own{i, share, {}};
  Arrival arrival{ring_.position(k), {}, ring_.spacing(k)};
  for (int d = 0; d < Dim; ++d) {
    arrival.carried_impulse[d] = points_.carried[i][d] * dt_;
    own.offset[d] = share * (points_.v[hub][d] - points_.v[i][d]) - absorption_rate * (arrival.x[d] - ring_.centroid()[d]);
  }
  const int last = Grid<Dim>::last;
  const int plane = static_cast<int>(std::floor((arrival.x[last] - grid.origin[last]) / grid.h));
  own_.push_back(own);
  leaving_.push_back(arrival);
  to_.push_back(grid.rank_of_plane(std::clamp(plane, 0, grid.cells[last] - 1)));
}

/// Force on each point from the fluid inside the object, in shares of mass: rho_f V (a + alpha x r) of its last step, and the weight it takes away.
/// a is that of the ring. Taken from all points, or given to the ring alone, a force that lags by a step would feed the oscillation of hub against ring
/// (the hub moves against ring and fluid, so the two signs differ); like this it damps it.
template <int Dim>
void CoupledFluid<Dim>::return_inner_fluid(const ObjectPoints &object, const ObjectMotion &motion, const std::array<double, 3> &gravity)
{
  const double ratio = options_.density * motion.natural_area / motion.mass;
  for (int k = -1; k < object.n_ring; ++k) {
    const int i = k < 0 ? object.hub : object.ring[k];
    if (!points_.owns(i)) continue;
    const double *state = points_.state[i];
    double ax = -gravity[0], ay = -gravity[1];
    if (state[FluidState::KNOWS_BEFORE] != 0.0) {
      const double alpha = (motion.spin - state[FluidState::RING_SPIN]) / dt_;
      ax += (motion.velocity[0] - state[FluidState::RING_VELOCITY_X]) / dt_ - alpha * (points_.x[i][1] - motion.centre[1]);
      ay += (motion.velocity[1] - state[FluidState::RING_VELOCITY_Y]) / dt_ + alpha * (points_.x[i][0] - motion.centre[0]);
    }
    points_.state[i][FluidState::BODY_FORCE_X] = ratio * points_.mass[i] * ax;
    points_.state[i][FluidState::BODY_FORCE_Y] = ratio * points_.mass[i] * ay;
  }
}

template <int Dim> void CoupledFluid<Dim>::remember_motion(const ObjectPoints &object, const ObjectMotion &motion)
{
  for (int k = -1; k < object.n_ring; ++k) {
    const int i = k < 0 ? object.hub : object.ring[k];
    if (!points_.owns(i)) continue;
    double *state = points_.state[i];
    state[FluidState::KNOWS_BEFORE] = 1.0;
    state[FluidState::RING_VELOCITY_X] = motion.velocity[0];
    state[FluidState::RING_VELOCITY_Y] = motion.velocity[1];
    state[FluidState::RING_SPIN] = motion.spin;
    state[FluidState::SWELLING] = points_.object_point[i][LAMMPS_NS::FixObjects::LAMBDA];
  }
}

template <int Dim> void CoupledFluid<Dim>::arrive()
{
  Stopwatch watch(seconds_in_coupling_);
  courier_.deliver(leaving_, to_, arrived_);
  x_.clear();
  carried_.clear();
  for (const Arrival &arrival : arrived_) {
    x_.push_back(arrival.x);
    carried_.push_back(arrival.carried_impulse);
  }
  markers_.place(x_);
  set_kappa();
}

/// kappa = rho_f ds h / (beta dt). Where markers crowd, their forces overlap: with the kernel's own scale they would overcorrect, and the step be unstable.
template <int Dim> void CoupledFluid<Dim>::set_kappa()
{
  const Grid<Dim> &grid = flow_.grid();
  row_sum_.resize(arrived_.size());
  kappa_.resize(arrived_.size());
  for (std::size_t l = 0; l < arrived_.size(); ++l) row_sum_[l].fill(options_.density * arrived_[l].spacing * grid.h);
  flow_.forcing().clear();
  markers_.spread(row_sum_, options_.density, flow_.forcing());
  flow_.forcing().complete();
  markers_.interpolate(flow_.forcing().field(), row_sum_);
  for (std::size_t l = 0; l < arrived_.size(); ++l) {
    const double beta = std::max(Roma1999::scale, *std::max_element(row_sum_[l].begin(), row_sum_[l].end()));
    kappa_[l] = options_.density * arrived_[l].spacing * grid.h / (beta * dt_);
  }
}

template <int Dim> void CoupledFluid<Dim>::spread(const std::vector<VecD> &impulses)
{
  Stopwatch watch(seconds_in_coupling_);
  flow_.forcing().clear();
  markers_.spread(impulses, options_.density, flow_.forcing());
  flow_.forcing().complete();
}

// ---- and back --------------------------------------------------------------------------------------------------------------------------------

template <int Dim> void CoupledFluid<Dim>::hand_out()
{
  Stopwatch watch(seconds_in_coupling_);
  markers_.interpolate(flow_.face_velocity_around(), u_);
  answers_.clear();
  for (std::size_t l = 0; l < arrived_.size(); ++l) answers_.push_back({u_[l], kappa_[l], static_cast<int>(l)});
  courier_.reply(answers_, answers_at_own_);

  for (std::size_t m = 0; m < own_.size(); ++m) {
    const OwnMarker &own = own_[m];
    const Answer &answer = answers_at_own_[m];
    double *law = points_.law[own.point], *state = points_.state[own.point];
    law[FluidLaw::KAPPA] = answer.kappa;
    for (int d = 0; d < Dim; ++d)
      law[FluidLaw::A_X + d] = answer.kappa * (answer.u[d] - own.offset[d]) - (1.0 - own.share) * points_.carried[own.point][d];
    state[FluidState::SHARE] = own.share;
    state[FluidState::HAS_MARKER] = 1.0;
    state[FluidState::SLAB_RANK] = to_[m];
    state[FluidState::SLOT] = answer.slot;
  }
}

/// Points may have migrated since the step began: each knows where its marker waits.
template <int Dim> void CoupledFluid<Dim>::collect(const std::vector<ObjectPoints> &objects)
{
  Stopwatch watch(seconds_in_coupling_);
  receipts_.clear();
  to_.clear();
  received_ = {};
  exchanged_ = 0.0;
  for (const ObjectPoints &object : objects) {
    if (points_.owns(object.hub))
      for (int d = 0; d < Dim; ++d) received_[d] += points_.impulse[object.hub][d];
    for (int k = 0; k < object.n_ring; ++k) {
      const int i = object.ring[k];
      if (!points_.owns(i) || points_.state[i][FluidState::HAS_MARKER] == 0.0) continue;
      const double *impulse = points_.impulse[i], *state = points_.state[i];
      double *carried = points_.carried[i];
      Receipt receipt{static_cast<int>(state[FluidState::SLOT]), {}};
      double square = 0.0;
      for (int d = 0; d < Dim; ++d) {
        received_[d] += impulse[d];
        receipt.impulse[d] = state[FluidState::SHARE] * carried[d] * dt_ - impulse[d];
        carried[d] = receipt.impulse[d] / dt_;
        square += carried[d] * carried[d];
      }
      exchanged_ += std::sqrt(square) * dt_;
      receipts_.push_back(receipt);
      to_.push_back(static_cast<int>(state[FluidState::SLAB_RANK]));
    }
  }
  courier_.deliver(receipts_, to_, arrived_receipts_);
  impulse_.assign(arrived_.size(), VecD{});
  for (const Receipt &receipt : arrived_receipts_) impulse_[receipt.slot] = receipt.impulse;
  change_.resize(arrived_.size());
  for (std::size_t l = 0; l < arrived_.size(); ++l)
    for (int d = 0; d < Dim; ++d) change_[l][d] = impulse_[l][d] - carried_[l][d];
}

// ---- balance and report ----------------------------------------------------------------------------------------------------------------------

/// Sum over the faces of this rank of what the forcing as it stands gives to the fluid.
template <int Dim> typename CoupledFluid<Dim>::VecD CoupledFluid<Dim>::given_to_fluid() const
{
  const auto &layout = flow_.layout();
  const auto &forcing = const_cast<FlowSolver<Dim> &>(flow_).forcing();
  VecD sum{};
  for (int k = 0; k < layout.planes(); ++k) {
    if (!forcing.touched(k)) continue;
    for (int c = 0; c < Dim; ++c)
      for (int r = 0; r < layout.rows(); ++r) {
        const double *f = forcing.faces(c) + layout.row(k, r);
        for (int i = 0; i < layout.row_length(); ++i) sum[c] += f[i];
      }
  }
  for (double &s : sum) s *= options_.density * flow_.grid().cell_volume();
  return sum;
}

template <int Dim> FluidReport CoupledFluid<Dim>::report()
{
  FluidReport report;
  report.max_divergence = flow_.max_divergence();
  report.cfl = dt_ > 0.0 ? flow_.max_speed_sum() * dt_ / flow_.grid().h : 0.0;
  report.kinetic_energy = flow_.kinetic_energy();

  // Slip: the fluid at the markers after the projection, against the velocity it was forced to, u~ + (J - F_c dt) / (kappa dt).
  std::vector<VecD> u_now;
  markers_.interpolate(flow_.face_velocity_around(), u_now);
  double sums[2 + 2 * Dim + 1] = {}, largest[2] = {0.0, marker_gap_};
  for (std::size_t l = 0; l < u_now.size() && l < impulse_.size(); ++l) {
    VecD slip;
    for (int d = 0; d < Dim; ++d) slip[d] = u_[l][d] + change_[l][d] / (kappa_[l] * dt_) - u_now[l][d];
    const double size = std::sqrt(std::inner_product(slip.begin(), slip.end(), slip.begin(), 0.0));
    sums[0] += size;
    sums[1] += 1.0;
    largest[0] = std::max(largest[0], size);
  }
  for (int d = 0; d < Dim; ++d) {
    sums[2 + d] = given_[d];
    sums[2 + Dim + d] = received_[d];
  }
  sums[2 + 2 * Dim] = exchanged_;
  MPI_Allreduce(MPI_IN_PLACE, sums, 2 + 2 * Dim + 1, MPI_DOUBLE, MPI_SUM, flow_.grid().comm);
  MPI_Allreduce(MPI_IN_PLACE, largest, 2, MPI_DOUBLE, MPI_MAX, flow_.grid().comm);

  if (sums[1] > 0.0) report.mean_slip = sums[0] / sums[1];
  report.max_slip = largest[0];
  report.marker_gap = largest[1];
  double error = 0.0;
  for (int d = 0; d < Dim; ++d) {
    if (dt_ > 0.0) report.force_on_objects[d] = sums[2 + Dim + d] / dt_;
    error = std::max(error, std::abs(sums[2 + d] + sums[2 + Dim + d]));
  }
  if (sums[2 + 2 * Dim] > 0.0) report.momentum_error = error / sums[2 + 2 * Dim];
  return report;
}

// ---- output ----------------------------------------------------------------------------------------------------------------------------------

template <int Dim> FieldBlock CoupledFluid<Dim>::field_block() const
{
  const Grid<Dim> &grid = flow_.grid();
  FieldBlock block;
  for (int d = 0; d < Dim; ++d) {
    block.global_cells[d] = grid.cells[d];
    block.count[d] = flow_.layout().cells(d);
    block.origin[d] = grid.origin[d];
  }
  block.first[Grid<Dim>::last] = grid.first_plane;
  block.spacing = grid.h;
  return block;
}

template <int Dim> std::vector<FieldInfo> CoupledFluid<Dim>::fields() const
{
  return {{"velocity", "length/time", 3}, {"pressure", "pressure", 1}};
}

template <int Dim> void CoupledFluid<Dim>::copy_field(const std::string &name, std::vector<double> &values) const
{
  const auto &layout = flow_.layout();
  values.clear();
  for (int k = 0; k < layout.planes(); ++k)
    for (int r = 0; r < layout.rows(); ++r)
      for (int i = 0; i < layout.row_length(); ++i) {
        const std::ptrdiff_t at = layout.row(k, r) + i;
        if (name == "pressure") {
          values.push_back(options_.density * flow_.pressure_over_density()[at]);
          continue;
        }
        for (int c = 0; c < 3; ++c) values.push_back(c < Dim ? flow_.velocity()[c][at] : 0.0);
      }
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
  const Grid<2> grid({options.cells[0], options.cells[1]}, {low[0], low[1]}, h, engine.communicator());
  WallVelocities<2> walls{};
  for (int side = 0; side < 4; ++side) walls[side] = {options.wall_velocity[side][0], options.wall_velocity[side][1]};
  return std::make_unique<CoupledFluid<2>>(lammps, options, grid, walls);
}

}  // namespace swellflow
