// The momentum of all cells changes by what comes through the sides and with sources, what the markers give and the body force: in every step, to round-off.
#include "flow.h"
#include "fluid/markers.h"

using namespace swellflow_test;

namespace {

constexpr double density = 3.0, nu = 0.02;

struct Box {
  const char *name;
  Boundaries<2> boundaries;
  bool sources = false;
};

std::vector<Box> boxes()
{
  Boundaries<2> lid = sides(Boundary::wall, Boundary::wall, Boundary::wall, Boundary::wall);
  lid.velocity[0] = {0.0, -0.4};
  lid.velocity[3] = {1.0, 0.0};
  Boundaries<2> pipe = sides(Boundary::periodic, Boundary::periodic, Boundary::slip, Boundary::wall);
  pipe.velocity[3] = {1.0, 0.0};
  Boundaries<2> upright = sides(Boundary::wall, Boundary::slip, Boundary::periodic, Boundary::periodic);
  upright.velocity[0] = {0.0, 1.0};
  Boundaries<2> stream = sides(Boundary::inflow, Boundary::outflow, Boundary::slip, Boundary::wall);
  stream.velocity[0] = {1.0, 0.3};
  Boundaries<2> down = sides(Boundary::outflow, Boundary::wall, Boundary::outflow, Boundary::parabolic_inflow);
  down.velocity[3] = {0.2, -1.0};
  return {{"cavity", lid},
          {"periodic in x", pipe},
          {"periodic in y", upright},
          {"periodic", sides(Boundary::periodic, Boundary::periodic, Boundary::periodic, Boundary::periodic)},
          {"stream", stream},
          {"downwards", down, true},
          {"sources alone", sides(Boundary::wall, Boundary::outflow, Boundary::slip, Boundary::wall), true}};
}

/// A stirred box with a circle of markers that touches a side and lies on several slabs.
class Stirred {
public:
  Stirred(const Boundaries<2> &boundaries, Advection advection, bool sources)
      : boundaries_(boundaries), sources_(sources), grid_({40, 32}, {}, 1.0 / 32, MPI_COMM_WORLD, boundaries.periodic()), flow_(grid_, {density, nu}, boundaries, advection),
        markers_(make_markers<2>("roma_1999", flow_.grid(), flow_.layout()))
  {
    for (int k = 0; k < flow_.layout().planes(); ++k)
      for (int i = 0; i < grid_.cells[0]; ++i) {
        const double x = (i + 0.5) * grid_.h, y = (k + grid_.first_plane + 0.5) * grid_.h;
        flow_.initial_velocity()[0][flow_.layout().row(k, 0) + i] = std::sin(7.0 * x) * std::cos(5.0 * y) + 0.2;
        flow_.initial_velocity()[1][flow_.layout().row(k, 0) + i] = std::cos(6.0 * x + 1.0) * std::sin(8.0 * y);
      }
    flow_.start_from_velocity();
    flow_.set_body_force({0.7, -0.4});
  }

  /// What is left of the momentum's change, over the sum of all magnitudes.
  double step(int n)
  {
    const double dt = 0.004 * (1.0 + 0.5 * (n % 3));
    for (int side = 0; side < 4; ++side) {
      Vec<2> velocity = boundaries_.velocity[side];
      for (double &component : velocity) component *= 1.0 + 0.3 * std::sin(0.9 * n);
      flow_.set_side_velocity(side, velocity);
    }
    change_ = momentum();
    for (double &component : change_) component = -component;
    magnitude_ = 0.0;
    place(n);
    give(0.3 * n);
    flow_.predict_velocity(dt);
    give(0.5 * n + 1.0);
    flow_.apply_forcing();
    if (sources_) grow(n);
    flow_.project(dt);
    EXPECT_LT(flow_.max_divergence(), 1e-11);
    book(momentum(), 1.0);
    Vec<2> brought = flow_.source_impulse_here();
    MPI_Allreduce(MPI_IN_PLACE, brought.data(), 2, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
    book(brought, -1.0);
    for (const Vec<2> &impulse : received()) book(impulse, -1.0);
    const Vec<2> &g = flow_.body_force();
    const double mass = density * grid_.cell_volume() * grid_.cells[0] * grid_.cells[1];
    book({mass * g[0] * dt, mass * g[1] * dt}, -1.0);
    return std::max(std::abs(change_[0]), std::abs(change_[1])) / magnitude_;
  }

  SideImpulses<2>::BySide received() const
  {
    auto sum = flow_.side_impulses_here();
    MPI_Allreduce(MPI_IN_PLACE, sum.data(), 8, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
    return sum;
  }

private:
  Vec<2> momentum() const
  {
    Vec<2> sum = flow_.mean_velocity();
    for (double &component : sum) component *= density * grid_.cell_volume() * grid_.cells[0] * grid_.cells[1];
    return sum;
  }
  void place(int n)
  {
    places_.clear();
    for (int l = 0; l < 24; ++l) {
      const Vec<2> x{0.3 + 0.01 * n + 0.25 * std::cos(0.2618 * l), 0.27 + 0.25 * std::sin(0.2618 * l)};
      if (grid_.rank_of_plane(static_cast<int>(x[1] / grid_.h)) == grid_.rank) places_.push_back(x);
    }
    markers_->place(places_);
  }
  /// Sources at the markers, and a sink.
  void grow(int n)
  {
    flow_.sources().clear();
    for (std::size_t l = 0; l < places_.size(); ++l) flow_.sources().add(places_[l], 0.01 * (l % 3) - 0.002 * n);
    flow_.sources().complete();
  }
  void give(double phase)
  {
    Vec<2> sum{};
    std::vector<Vec<2>> impulses(markers_->size());
    for (std::size_t l = 0; l < impulses.size(); ++l) {
      impulses[l] = {1e-3 * std::cos(phase + l), 1e-3 * std::sin(2.0 * phase + l)};
      for (int d = 0; d < 2; ++d) sum[d] += impulses[l][d];
    }
    MPI_Allreduce(MPI_IN_PLACE, sum.data(), 2, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
    flow_.forcing().clear();
    markers_->spread(impulses, density, flow_.forcing());
    flow_.forcing().complete();
    book(sum, -1.0);
  }
  void book(const Vec<2> &impulse, double sign)
  {
    for (int d = 0; d < 2; ++d) {
      change_[d] += sign * impulse[d];
      magnitude_ += std::abs(impulse[d]);
    }
  }

  Boundaries<2> boundaries_;
  bool sources_;
  Grid<2> grid_;
  FlowSolver<2> flow_;
  std::vector<Vec<2>> places_;
  std::unique_ptr<Markers<2>> markers_;
  Vec<2> change_{};
  double magnitude_ = 0.0;
};

TEST(MomentumBalance, HoldsInEveryStep)
{
  for (const Box &box : boxes())
    for (const Advection advection : {Advection::central, Advection::bounded, Advection::none}) {
      Stirred flow(box.boundaries, advection, box.sources);
      double largest = 0.0;
      for (int n = 0; n < 12; ++n) largest = std::max(largest, flow.step(n));
      EXPECT_LT(largest, 1e-12) << box.name << ", advection " << static_cast<int>(advection);
    }
}

// What appears leaves, through one outflow, or through two in equal parts; what vanishes comes in there.
TEST(Sources, LeaveThroughTheOutflows)
{
  for (const bool both : {false, true}) {
    Flow flow(32, 32, 1.0 / 32, 0.01, sides(both ? Boundary::outflow : Boundary::slip, Boundary::outflow, Boundary::slip, Boundary::slip));
    const auto leaving = [&] {
      double sum[2] = {};
      for (int k = 0; k < flow.solver.layout().planes(); ++k) {
        sum[0] -= flow.grid.h * flow.solver.face_velocity()[0][flow.solver.layout().row(k, 0)];
        sum[1] += flow.grid.h * flow.solver.face_velocity()[0][flow.solver.layout().row(k, 0) + 32];
      }
      MPI_Allreduce(MPI_IN_PLACE, sum, 2, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
      return std::array<double, 2>{sum[0], sum[1]};
    };
    for (int s = 1; s <= 20; ++s) {
      const double rate = 0.1 * std::sin(0.4 * s);  // a sink from the eighth step on
      flow.solver.sources().clear();
      if (flow.grid.rank_of_plane(16) == flow.grid.rank) flow.solver.sources().add({0.5, 0.5}, rate);
      flow.solver.sources().complete();
      flow.step(0.01);
      EXPECT_NEAR(flow.solver.sources().total(), rate, 1e-15);
      EXPECT_NEAR(leaving()[1], both ? 0.5 * rate : rate, 1e-13);
      EXPECT_NEAR(leaving()[0], both ? 0.5 * rate : 0.0, 1e-13);
      EXPECT_LT(flow.solver.max_divergence(), 1e-11);
    }
  }
}

TEST(Sources, NeedAnOutflow)
{
  Flow flow(8, 8, 0.125, 0.01, sides(Boundary::wall, Boundary::wall, Boundary::wall, Boundary::wall));
  EXPECT_THROW(flow.solver.sources(), std::invalid_argument);
}

// Between plates the two walls share what the body force gives; a side that slides bears no shear.
TEST(MomentumBalance, WallsOfAChannelBearHalfOfTheDriveEach)
{
  for (const bool slides : {false, true}) {
    const Boundaries<2> plates = sides(Boundary::periodic, Boundary::periodic, slides ? Boundary::slip : Boundary::wall, Boundary::wall);
    Flow flow(16, 16, 1.0 / 16, 0.5, plates);
    flow.solver.set_body_force({1.0, 0.0});
    flow.run(32.0, 0.01);
    auto received = flow.solver.side_impulses_here();
    MPI_Allreduce(MPI_IN_PLACE, received.data(), 8, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
    EXPECT_NEAR(received[2][0], slides ? 0.0 : -0.005, 1e-12);
    EXPECT_NEAR(received[3][0], slides ? -0.01 : -0.005, 1e-12);
    for (const int side : {0, 1}) EXPECT_EQ(received[side], (Vec<2>{}));
  }
}

}  // namespace
