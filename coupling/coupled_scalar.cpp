#include "coupling/coupled_scalar.h"

#include <algorithm>
#include <cmath>

#include "coupling/coupled_fluid.h"
#include "coupling/stopwatch.h"

namespace swellflow {

namespace {

template <int Dim> typename ScalarTransport<Dim>::Sides sides_of(const ScalarOptions &options)
{
  typename ScalarTransport<Dim>::Sides sides;
  for (int side = 0; side < 2 * Dim; ++side) switch (options.sides[side]) {
      case ScalarSideKind::feed: sides[side] = ScalarSide::feed; break;
      case ScalarSideKind::value: sides[side] = ScalarSide::value; break;
      default: sides[side] = ScalarSide::open;
    }
  return sides;
}

}  // namespace

template <int Dim>
CoupledScalar<Dim>::CoupledScalar(CoupledFluid<Dim> &fluid, const ScalarOptions &options)
    : fluid_(fluid), grid_(fluid.flow().grid()), layout_(fluid.flow().layout()), name_(options.name),
      transport_(grid_, layout_, options.diffusivity, sides_of<Dim>(options)), to_slabs_(grid_.comm)
{
  for (int k = 0; k < layout_.planes(); ++k)
    for (int r = 0; r < layout_.rows(); ++r)
      for (int i = 0; i < layout_.row_length(); ++i) {
        std::array<int, 3> cell{i, r, 0};
        cell[Grid<Dim>::last] = grid_.first_plane + k;
        Triple centre{};
        for (int d = 0; d < Dim; ++d) centre[d] = grid_.origin[d] + (cell[d] + 0.5) * grid_.h;
        transport_.values()[layout_.row(k, r) + i] = options.initial(centre);
      }
  total_at_start_ = transport_.total_here();
}

template <int Dim>
void CoupledScalar<Dim>::step(const std::array<double, 6> &side_values, const std::vector<double> *withdrawal, std::vector<ScalarMet> &met)
{
  Stopwatch watch(seconds_);
  const FlowSolver<Dim> &flow = fluid_.flow();
  for (int side = 0; side < 2 * Dim; ++side) transport_.set_side_value(side, side_values[side]);
  transport_.advance(fluid_.last_step(), flow.face_velocity(), flow.has_sources());
  fluid_.markers().place_in_cells(fluid_.marker_places());
  if (withdrawal) withdraw(*withdrawal);
  require_finite();
  fluid_.markers().interpolate(transport_.values_around(), at_markers_);
  fluid_.hear_markers(at_markers_, met);
}

/// Ends the run on all ranks alike.
template <int Dim> void CoupledScalar<Dim>::require_finite() const
{
  double total = transport_.total_here();
  MPI_Allreduce(MPI_IN_PLACE, &total, 1, MPI_DOUBLE, MPI_SUM, grid_.comm);
  if (!std::isfinite(total))
    throw NotFinite("the scalar '" + name_ + "' must stay finite, but is not after a fluid step of length " + std::to_string(fluid_.last_step()) +
                             ": give it smaller values or a smaller 'diffusivity', or use a smaller 'timestep' or 'every'");
}

template <int Dim> void CoupledScalar<Dim>::withdraw(const std::vector<double> &by_point)
{
  fluid_.tell_markers(by_point, at_markers_);
  for (std::size_t l = 0; l < at_markers_.size(); ++l) at_markers_[l] *= fluid_.marker_spacings()[l];
  fluid_.markers().spread(at_markers_, transport_.withdrawal());
  transport_.withdraw();
}

// ---- values at places ------------------------------------------------------------------------------------------------------------------------

/// In the whole grid; of a place beyond a side the cell there.
template <int Dim> std::array<int, Dim> CoupledScalar<Dim>::cell_of(const Triple &place) const
{
  std::array<int, Dim> cell;
  for (int d = 0; d < Dim; ++d) {
    const int n = grid_.cells[d];
    const double in_cells = std::floor((place[d] - grid_.origin[d]) / grid_.h);
    cell[d] = static_cast<int>(grid_.periodic[d] ? in_cells - n * std::floor(in_cells / n) : std::clamp(in_cells, 0.0, n - 1.0));
  }
  return cell;
}

template <int Dim> std::vector<double> CoupledScalar<Dim>::values_at(const std::vector<Triple> &places)
{
  std::vector<std::array<int, Dim>> cells;
  Arrivals<std::array<int, Dim>> arrived;
  std::vector<int> to;
  for (const Triple &place : places) {
    cells.push_back(cell_of(place));
    to.push_back(grid_.rank_of_plane(cells.back()[Grid<Dim>::last]));
  }
  to_slabs_.deliver(cells, to, arrived);
  std::vector<double> answers;
  Arrivals<double> values;
  for (std::array<int, Dim> cell : arrived) {
    cell[Grid<Dim>::last] -= grid_.first_plane;
    answers.push_back(transport_.values()[layout_.at(cell)]);
  }
  to_slabs_.reply(answers, values);
  return {values.begin(), values.end()};
}

template <int Dim> ScalarReport CoupledScalar<Dim>::report()
{
  const auto &budget = transport_.budget();
  double sums[] = {transport_.total_here(), total_at_start_, budget.entered, budget.left, budget.withdrawn, budget.appeared};
  const auto here = transport_.extremes_here();
  double extremes[] = {-here.smallest, here.largest};
  MPI_Allreduce(MPI_IN_PLACE, sums, 6, MPI_DOUBLE, MPI_SUM, grid_.comm);
  MPI_Allreduce(MPI_IN_PLACE, extremes, 2, MPI_DOUBLE, MPI_MAX, grid_.comm);
  double volume = grid_.cell_volume();
  for (const int cells : grid_.cells) volume *= cells;
  const auto [total, start, entered, left, withdrawn, appeared] = sums;
  const double magnitude = std::abs(start) + std::abs(entered) + std::abs(left) + std::abs(withdrawn) + std::abs(appeared);
  const double error = std::abs(total - (start + entered - left - withdrawn + appeared));
  return {.total = total, .mean = total / volume, .smallest = -extremes[0], .largest = extremes[1], .entered = entered, .left = left, .withdrawn = withdrawn,
          .appeared = appeared, .balance_error = magnitude > 0.0 ? error / magnitude : 0.0, .sub_steps = transport_.sub_steps()};
}

template <int Dim> void CoupledScalar<Dim>::keep(Checkpoint &file)
{
  transport_.keep(file, name_);
  file.parts("total at the start of " + name_, &total_at_start_, 1);
}

template class CoupledScalar<2>;

}  // namespace swellflow
