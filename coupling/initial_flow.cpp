#include "coupling/initial_flow.h"

namespace swellflow {

namespace {

/// Wall velocities lie within the walls and do not change along them, so that nothing diverges, and the profile is one that the scheme keeps as it is.
template <int Dim> void start_linear(FlowSolver<Dim> &flow, const Boundaries<Dim> &boundaries, int direction)
{
  const Grid<Dim> &grid = flow.grid();
  const Layout<Dim> &layout = flow.layout();
  const Vec<Dim> &lower = boundaries.velocity[2 * direction], &upper = boundaries.velocity[2 * direction + 1];
  for (int k = 0; k < layout.planes(); ++k)
    for (int r = 0; r < layout.rows(); ++r)
      for (int i = 0; i < layout.row_length(); ++i) {
        std::array<int, Dim> cell{};
        cell[0] = i;
        if constexpr (Dim == 3) cell[1] = r;
        cell[Grid<Dim>::last] = grid.first_plane + k;
        const double way = (cell[direction] + 0.5) / grid.cells[direction];
        for (int c = 0; c < Dim; ++c) flow.initial_velocity()[c][layout.row(k, r) + i] = (1.0 - way) * lower[c] + way * upper[c];
      }
  flow.start_from_velocity();
}

}  // namespace

template <int Dim> void start(FlowSolver<Dim> &flow, const Boundaries<Dim> &boundaries, const FluidOptions &options)
{
  if (options.linear_start) return start_linear(flow, boundaries, *options.linear_start);
  Vec<Dim> velocity;
  std::copy_n(options.initial_velocity.begin(), Dim, velocity.begin());
  flow.start_with_velocity(velocity);
}

template void start(FlowSolver<2> &, const Boundaries<2> &, const FluidOptions &);

}  // namespace swellflow
