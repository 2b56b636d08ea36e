// Interpolation and spreading: adjointness, partition of unity up to the walls, periodic directions, with every kernel.
#include <gtest/gtest.h>

#include <random>

#include "fluid/delta_kernel.h"
#include "fluid/markers.h"

using namespace swellflow;

namespace {

template <class Kernel> double phi(bool along, double r)
{
  if constexpr (requires { typename Kernel::Across; }) return along ? Kernel::Along::phi(r) : Kernel::Across::phi(r);
  else return Kernel::phi(r);
}

/// A box whose slabs have 2 planes on 4 ranks, and the same cloud of markers on every number of ranks; each rank takes what lies in its slab.
template <int Dim> struct Cloud {
  static constexpr double h = 0.25, density = 7.0;
  static constexpr std::array<int, 3> size{5, 6, 8};

  Grid<Dim> grid;
  Layout<Dim> layout{grid};
  std::unique_ptr<Markers<Dim>> markers;
  FaceForcing<Dim> forcing{grid, layout};
  VectorField<Dim> faces{layout};
  std::vector<Vec<Dim>> all_positions, all_values, positions, values;

  Cloud(const std::string &kernel, std::array<bool, Dim> periodic)
      : grid(cells(), origin(), h, MPI_COMM_WORLD, periodic), markers(make_markers<Dim>(kernel, grid, layout))
  {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> unit(0.0, 1.0), value(-1.0, 1.0);
    for (int l = 0; l < 300; ++l) {
      Vec<Dim> x, v;
      for (int d = 0; d < Dim; ++d) {
        const double s = l % (5 + 2 * d) == 0 ? l % 2 : unit(random);  // many lie on the sides and at corners
        x[d] = grid.origin[d] + s * grid.cells[d] * h;
        v[d] = value(random);
      }
      all_positions.push_back(x);
      all_values.push_back(v);
      const int plane = std::min(grid.cells[Dim - 1] - 1, static_cast<int>((x[Dim - 1] - grid.origin[Dim - 1]) / h));
      if (grid.rank_of_plane(plane) != grid.rank) continue;
      positions.push_back(x);
      values.push_back(v);
    }
    markers->place(positions);
  }
  static std::array<int, Dim> cells()
  {
    std::array<int, Dim> n;
    std::copy_n(size.end() - Dim, Dim, n.begin());
    return n;
  }
  static Vec<Dim> origin()
  {
    Vec<Dim> x;
    for (int d = 0; d < Dim; ++d) x[d] = -1.0 + 3.0 * d;
    return x;
  }

  /// f(c, offset, cell of the box) over this rank's cells, in periodic directions `around` ghosts included (their cell is that which they stand for).
  template <class F> void each_face(int around, F &&f) const
  {
    std::array<int, Dim> low{}, high, i;
    for (int d = 0; d < Dim; ++d) {
      low[d] = grid.periodic[d] ? -around : 0;
      high[d] = layout.cells(d) - low[d];
    }
    for (i = low; i[Dim - 1] < high[Dim - 1];) {
      std::array<int, Dim> cell = i;
      cell[Dim - 1] += grid.first_plane;
      for (int d = 0; d < Dim; ++d) cell[d] = (cell[d] + grid.cells[d]) % grid.cells[d];
      for (int c = 0; c < Dim; ++c) f(c, layout.at(i), cell);
      for (int d = 0; d < Dim; ++d) {
        if (++i[d] < high[d] || d == Dim - 1) break;
        i[d] = low[d];
      }
    }
  }
  bool on_wall(int c, const std::array<int, Dim> &cell) const { return !grid.periodic[c] && cell[c] == 0; }

  Vec<Dim> sum_over_ranks(Vec<Dim> sum) const
  {
    MPI_Allreduce(MPI_IN_PLACE, sum.data(), Dim, MPI_DOUBLE, MPI_SUM, grid.comm);
    return sum;
  }

  /// A field whose ghosts are right.
  void make_waves()
  {
    each_face(0, [&](int c, std::ptrdiff_t at, const auto &cell) {
      double phase = 1.0 + c;
      for (int d = 0; d < Dim; ++d) phase += cell[d] * (0.7 + 0.6 * d);
      faces[c][at] = std::sin(phase);
    });
    Halo<Dim> halo(grid, layout);
    for (int c = 0; c < Dim; ++c) {
      halo.wrap(faces[c], 2);
      halo.fill(faces[c], 2);
    }
  }

  void spread()
  {
    markers->spread(values, density, forcing);
    forcing.complete();
  }

  void expect_whole_impulse()
  {
    spread();
    Vec<Dim> given{}, total{};
    each_face(0, [&](int c, std::ptrdiff_t at, const auto &cell) {
      if (on_wall(c, cell)) {
        EXPECT_EQ(forcing.faces(c)[at], 0.0);
      }
      given[c] += density * grid.cell_volume() * forcing.faces(c)[at];
    });
    for (const auto &v : values)
      for (int c = 0; c < Dim; ++c) total[c] += v[c];
    given = sum_over_ranks(given);
    total = sum_over_ranks(total);
    for (int c = 0; c < Dim; ++c) EXPECT_NEAR(given[c], total[c], 1e-11);
  }

  void expect_adjoint()
  {
    make_waves();
    std::vector<Vec<Dim>> u;
    markers->interpolate(faces, u);
    spread();
    Vec<Dim> left{}, right{};
    for (std::size_t l = 0; l < u.size(); ++l)
      for (int c = 0; c < Dim; ++c) left[c] += values[l][c] * u[l][c];
    each_face(0, [&](int c, std::ptrdiff_t at, const auto &) { right[c] += density * grid.cell_volume() * forcing.faces(c)[at] * faces[c][at]; });
    left = sum_over_ranks(left);
    right = sum_over_ranks(right);
    for (int c = 0; c < Dim; ++c) EXPECT_NEAR(left[c], right[c], 1e-11);
  }

  /// Every face, ghosts included, has the sum over all markers of all ranks at their nearest images; all directions periodic.
  template <class Kernel> void expect_sum_over_kernels()
  {
    spread();
    each_face(2, [&](int c, std::ptrdiff_t at, const auto &cell) {
      double sum = 0.0;
      for (std::size_t l = 0; l < all_positions.size(); ++l) {
        double weight = all_values[l][c] / (density * grid.cell_volume());
        for (int d = 0; d < Dim; ++d)
          weight *= phi<Kernel>(d == c, std::remainder((all_positions[l][d] - grid.origin[d]) / h - cell[d] - (d == c ? 0.0 : 0.5), grid.cells[d]));
        sum += weight;
      }
      EXPECT_NEAR(forcing.faces(c)[at], sum, 1e-6);
    });
  }
};

class MarkersOnSlabs : public testing::TestWithParam<std::tuple<const char *, bool, bool>> {
protected:
  Cloud<2> cloud{std::get<0>(GetParam()), {std::get<1>(GetParam()), std::get<2>(GetParam())}};
};

INSTANTIATE_TEST_SUITE_P(KernelsAndPeriods, MarkersOnSlabs,
                         testing::Combine(testing::Values("roma_1999", "peskin_2002", "yang_2009", "gruninger_2025"), testing::Bool(), testing::Bool()));

TEST_P(MarkersOnSlabs, InterpolateAConstantExactlyUpToTheWalls)
{
  for (int c = 0; c < 2; ++c) std::fill_n(cloud.faces[c].data(), cloud.layout.size(), 3.0 + c);
  std::vector<Vec<2>> u;
  cloud.markers->interpolate(cloud.faces, u);
  for (const auto &v : u)
    for (int c = 0; c < 2; ++c) EXPECT_NEAR(v[c], 3.0 + c, 1e-13);
}

TEST_P(MarkersOnSlabs, GiveTheFluidTheWholeImpulse) { cloud.expect_whole_impulse(); }

TEST_P(MarkersOnSlabs, SpreadingIsTheAdjointOfInterpolation) { cloud.expect_adjoint(); }

TEST_P(MarkersOnSlabs, ShiftedByAPeriodAreTheSame)
{
  cloud.make_waves();
  std::vector<Vec<2>> u, shifted_u;
  cloud.markers->interpolate(cloud.faces, u);
  for (std::size_t l = 0; l < u.size(); ++l)
    for (int d = 0; d < 2; ++d)
      if (cloud.grid.periodic[d]) cloud.positions[l][d] += (l % 2 ? 1 : -1) * cloud.h * cloud.grid.cells[d];
  cloud.markers->place(cloud.positions);
  cloud.markers->interpolate(cloud.faces, shifted_u);
  for (std::size_t l = 0; l < u.size(); ++l)
    for (int c = 0; c < 2; ++c) EXPECT_NEAR(u[l][c], shifted_u[l][c], 1e-7);  // the kernels' square roots
}

/// The same operators for values in the cells: amounts are given as a whole, to the cells that interpolation reads; a slope is read as it is, away from the sides.
TEST_P(MarkersOnSlabs, ServeValuesInCells)
{
  std::vector<double> given, read;
  for (const auto &v : cloud.values) given.push_back(v[0]);
  cloud.markers->place_in_cells(cloud.positions);
  Field<2> &spread = cloud.faces[0], &waves = cloud.faces[1];
  cloud.markers->spread(given, spread);
  Halo<2> halo(cloud.grid, cloud.layout);
  halo.add(spread);
  for (int k = 0; k < cloud.layout.planes(); ++k) halo.fold(spread, k);
  Vec<2> amounts{}, products{};  // given, arrived
  cloud.each_face(0, [&](int c, std::ptrdiff_t at, const auto &cell) {
    if (c > 0) return;
    waves[at] = std::sin(1.0 + 0.7 * cell[0] + 1.3 * cell[1]);
    amounts[1] += cloud.grid.cell_volume() * spread[at];
    products[1] += cloud.grid.cell_volume() * spread[at] * waves[at];
  });
  halo.wrap(waves, 2);
  halo.fill(waves, 2);
  cloud.markers->interpolate(waves, read);
  for (std::size_t l = 0; l < given.size(); ++l) {
    amounts[0] += given[l];
    products[0] += given[l] * read[l];
  }
  amounts = cloud.sum_over_ranks(amounts);
  products = cloud.sum_over_ranks(products);
  EXPECT_NEAR(amounts[0], amounts[1], 1e-11);
  EXPECT_NEAR(products[0], products[1], 1e-11);

  const auto along = [&](int d, const Vec<2> &x) { return (x[d] - cloud.grid.origin[d]) / cloud.h; };
  for (int d = 0; d < 2; ++d) {
    cloud.each_face(0, [&](int c, std::ptrdiff_t at, const auto &cell) { waves[at] = c == d ? cell[d] + 0.5 : waves[at]; });
    halo.wrap(waves, 2);
    halo.fill(waves, 2);
    cloud.markers->interpolate(waves, read);
    for (std::size_t l = 0; l < read.size(); ++l) {
      const double s = along(d, cloud.positions[l]);
      if (s > 2.5 && s < cloud.grid.cells[d] - 2.5) {
        EXPECT_NEAR(read[l], s, 1e-12);
      }
    }
  }
}

/// Each marker alone: what no plane says that it holds is not seen by the flow solver, nor cleared.
TEST_P(MarkersOnSlabs, ChangeOnlyPlanesThatAreTouched)
{
  const auto largest_in = [&](int k) {
    double largest = 0.0;
    for (int c = 0; c < 2; ++c)
      for (std::ptrdiff_t i = 0; i < cloud.layout.plane_stride(); ++i)
        largest = std::max(largest, std::abs(cloud.forcing.faces(c)[cloud.layout.plane_begin(k) + i]));
    return largest;
  };
  for (int plane = 0; plane < cloud.grid.cells[1]; ++plane) {
    std::vector<Vec<2>> here;
    if (cloud.grid.rank_of_plane(plane) == cloud.grid.rank) here.push_back({cloud.grid.origin[0], cloud.grid.origin[1] + plane * cloud.h});
    cloud.markers->place(here);
    cloud.values.assign(here.size(), Vec<2>{1.0, 1.0});
    cloud.spread();
    for (int k = -2; k < cloud.layout.planes() + 2; ++k) EXPECT_TRUE(cloud.forcing.touched(k) || largest_in(k) == 0.0) << plane << ' ' << k;
    cloud.forcing.clear();
    for (int k = -2; k < cloud.layout.planes() + 2; ++k) EXPECT_EQ(largest_in(k), 0.0) << plane << ' ' << k;
  }
}

TEST(PeriodicBox, FacesAndGhostsHaveTheSumOverAllMarkers)
{
  Cloud<2>("roma_1999", {true, true}).expect_sum_over_kernels<Roma1999>();
  Cloud<2>("peskin_2002", {true, true}).expect_sum_over_kernels<Peskin2002>();
  Cloud<2>("yang_2009", {true, true}).expect_sum_over_kernels<Yang2009>();
  Cloud<2>("gruninger_2025", {true, true}).expect_sum_over_kernels<Gruninger2025>();
  Cloud<3>("yang_2009", {true, true, true}).expect_sum_over_kernels<Yang2009>();
  Cloud<3>("gruninger_2025", {true, true, true}).expect_sum_over_kernels<Gruninger2025>();
}

TEST(ThreeDimensions, OperatorsAreAdjointAndConserve)
{
  for (bool x : {false, true})
    for (bool y : {false, true})
      for (bool z : {false, true}) {
        Cloud<3>("peskin_2002", {x, y, z}).expect_adjoint();
        Cloud<3>("peskin_2002", {x, y, z}).expect_whole_impulse();
      }
}

/// What `scale` says: a straight outline along the grid, markers a cell apart, each asked to change the fluid by 1 over its own length of outline.
TEST(Scale, IsWhatComesBackFromAStraightOutline)
{
  for (const char *kernel : {"roma_1999", "peskin_2002", "yang_2009", "gruninger_2025"}) {
    const Grid<2> grid({8, 8}, {0.0, 0.0}, 1.0, MPI_COMM_SELF, {true, true});
    const Layout<2> layout(grid);
    const auto markers = make_markers<2>(kernel, grid, layout);
    FaceForcing<2> forcing(grid, layout);
    double sum = 0.0;
    constexpr int offsets = 100;
    for (int n = 0; n < offsets; ++n) {
      std::vector<Vec<2>> x, u;
      for (int i = 0; i < 8; ++i) x.push_back({i + 0.3, 3.0 + (n + 0.5) / offsets});
      markers->place(x);
      forcing.clear();
      markers->spread(std::vector<Vec<2>>(8, {1.0, 1.0}), 1.0, forcing);
      forcing.complete();
      markers->interpolate(forcing.field(), u);
      sum += u[n % 8][n % 2];
    }
    EXPECT_NEAR(sum / offsets, markers->scale(), 2e-5) << kernel;
  }
}

TEST(MakeMarkers, RefusesAnUnknownKernel)
{
  const Grid<2> grid({8, 8}, {0.0, 0.0}, 1.0, MPI_COMM_SELF);
  const Layout<2> layout(grid);
  try {
    make_markers<2>("cosine", grid, layout);
    FAIL();
  } catch (const std::invalid_argument &error) {
    EXPECT_STREQ(error.what(), "the kernel must be roma_1999, peskin_2002, yang_2009 or gruninger_2025, but is 'cosine'");
  }
}

}  // namespace
