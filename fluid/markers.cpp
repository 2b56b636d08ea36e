#include "fluid/markers.h"

#include <Eigen/Core>
#include <cassert>
#include <limits>
#include <stdexcept>

#include "fluid/delta_kernel.h"

namespace swellflow {

namespace {

template <int Dim, class Kernel> class KernelMarkers final : public Markers<Dim> {
public:
  KernelMarkers(const Grid<Dim> &grid, const Layout<Dim> &layout) : grid_(grid), layout_(layout)
  {
    if (layout.size() > static_cast<std::size_t>(std::numeric_limits<int>::max()))
      throw std::invalid_argument("a rank must have less than 2^31 cells with those around them, but has " + std::to_string(layout.size()) + ": use more ranks");
    for (int d = 0; d < Dim; ++d) {
      const int begin = d == Grid<Dim>::last ? grid.first_plane : 0, n = layout.cells(d);
      constexpr int ghost = Grid<Dim>::ghost;
      directions_[d] = {.periodic = grid.periodic[d], .begin = begin, .cells = grid.cells[d], .lowest = begin - ghost, .highest = begin + n + ghost - width,
                        .origin = grid.origin[d], .size = 1.0 * grid.cells[d], .middle = begin + 0.5 * n};
    }
  }

  void place(std::span<const Vec<Dim>> positions) override;
  int size() const override { return static_cast<int>(stencils_.size()); }
  using typename Markers<Dim>::Interpolation;
  using typename Markers<Dim>::Spreading;
  using Markers<Dim>::interpolate;
  using Markers<Dim>::spread;
  void interpolate(std::initializer_list<Interpolation> wanted) const override;
  void spread(std::initializer_list<Spreading> wanted, double density) const override;
  void place_in_cells(std::span<const Vec<Dim>> positions) override;
  void interpolate(const Field<Dim> &cells, std::vector<double> &values) const override;
  void spread(const std::vector<double> &amounts, Field<Dim> &cells) const override;
  double scale() const override { return Kernel::scale; }
  double retraction() const override { return Kernel::retraction; }

private:
  static constexpr int width = Kernel::width;
  static constexpr int centres = Dim;  // in the place of a component: of the cells
  /// Rows along direction 0 are taken as vectors: behind the last weight of an odd kernel comes a zero.
  static constexpr int row_width = 4;
  static_assert(width <= row_width);
  using Row = Eigen::Array<double, row_width, 1>;
  using Faces = Eigen::Map<Row>;
  using ConstFaces = Eigen::Map<const Row>;
  struct Stencil {
    std::array<double, row_width> along;
    std::array<std::array<double, width>, Dim - 1> across;  // by direction from 1 on, point
    int first, first_plane;                                 // the lowest point of the support
    ConstFaces row() const { return ConstFaces(along.data()); }
  };

  /// What a direction of the slab is to markers, in cells.
  struct Direction {
    bool periodic;
    int begin, cells;               // the slab's first plane; cells of the box
    int lowest, highest;            // first points of a support
    double origin, size, middle;    // the box's lower corner [length], its size; the slab's middle
  };
  Vec<Dim> in_cells(const Vec<Dim> &position) const;
  static void weigh(bool along, double r, double *w)
  {
    if constexpr (!requires { typename Kernel::Across; }) Kernel::weights(r, w);
    else if (along) Kernel::Along::weights(r, w);
    else Kernel::Across::weights(r, w);
  }
  Stencil stencil_of(const Vec<Dim> &x, int c) const;
  static void leave_out_walls(int first, int lowest, int highest, double *w);

  /// visit(first point of a row, weight of the row)
  template <class Visit> void each_row(const Stencil &stencil, Visit &&visit) const
  {
    const auto &w = stencil.across;
    for (int j = 0; j < width; ++j) {
      const std::ptrdiff_t at = stencil.first + j * layout_.stride(1);
      if constexpr (Dim == 2) visit(at, w[0][j]);
      else
        for (int k = 0; k < width; ++k) visit(at + k * layout_.stride(2), w[1][k] * w[0][j]);
    }
  }
  double sum_of(const Stencil &stencil, const double *values) const
  {
    Row sum = Row::Zero();
    each_row(stencil, [&](std::ptrdiff_t at, double weight) { sum += weight * ConstFaces(values + at); });
    return (sum * stencil.row()).sum();
  }
  void add_to(double *values, const Stencil &stencil, double amount) const
  {
    const Row row = amount * stencil.row();
    each_row(stencil, [&](std::ptrdiff_t at, double weight) { Faces(values + at) += weight * row; });
  }

  const Grid<Dim> &grid_;
  const Layout<Dim> &layout_;
  std::array<Direction, Dim> directions_;
  std::vector<std::array<Stencil, Dim>> stencils_;  // by component
  std::vector<Stencil> cell_stencils_;
};

template <int Dim, class Kernel> void KernelMarkers<Dim, Kernel>::place(std::span<const Vec<Dim>> positions)
{
  stencils_.resize(positions.size());
  for (std::size_t l = 0; l < positions.size(); ++l) {
    const Vec<Dim> x = in_cells(positions[l]);
    for (int c = 0; c < Dim; ++c) stencils_[l][c] = stencil_of(x, c);
  }
}

template <int Dim, class Kernel> void KernelMarkers<Dim, Kernel>::place_in_cells(std::span<const Vec<Dim>> positions)
{
  cell_stencils_.resize(positions.size());
  for (std::size_t l = 0; l < positions.size(); ++l) cell_stencils_[l] = stencil_of(in_cells(positions[l]), centres);
}

/// In units of h from the box's lower corner; in a periodic direction of all images that nearest to the middle of the slab.
template <int Dim, class Kernel> Vec<Dim> KernelMarkers<Dim, Kernel>::in_cells(const Vec<Dim> &position) const
{
  Vec<Dim> result;
  for (int d = 0; d < Dim; ++d) {
    const Direction &along = directions_[d];
    const double x = (position[d] - along.origin) / grid_.h;
    result[d] = along.periodic ? x - along.size * std::floor((x - along.middle) / along.size + 0.5) : std::clamp(x, 0.0, along.size);
  }
  return result;
}

/// Of a velocity component, or `centres`.
template <int Dim, class Kernel>
[[gnu::always_inline]] inline typename KernelMarkers<Dim, Kernel>::Stencil KernelMarkers<Dim, Kernel>::stencil_of(const Vec<Dim> &x, int c) const
{
  Stencil stencil;
  stencil.along.back() = 0.0;
  std::array<int, Dim> first;
  for (int d = 0; d < Dim; ++d) {
    const Direction &along = directions_[d];
    // Faces of component c lie at whole numbers in direction c, at half ones in the others; cells at half ones in all.
    const double y = x[d] - (d == c ? 0.0 : 0.5);
    const int anchor = static_cast<int>(std::floor(y + (width % 2 ? 0.5 : 0.0)));
    // A marker on the upper end of its slab, or beyond by rounding, has the points of one just below.
    first[d] = std::clamp(anchor - Kernel::anchor, along.lowest, along.highest);
    assert(std::abs(first[d] - (anchor - Kernel::anchor)) <= 1 && "a marker must lie in this rank's slab");
    double *w = d == 0 ? stencil.along.data() : stencil.across[d - 1].data();
    weigh(d == c, y - (first[d] + Kernel::anchor), w);
    if (!along.periodic) leave_out_walls(first[d], d == c ? 1 : 0, along.cells - 1, w);
    first[d] -= along.begin;
  }
  stencil.first_plane = first[Dim - 1];
  stencil.first = static_cast<int>(layout_.at(first));
  return stencil;
}

/// Only the points lowest … highest of the box are the fluid's.
template <int Dim, class Kernel>
void KernelMarkers<Dim, Kernel>::leave_out_walls(int first, int lowest, int highest, double *w)
{
  if (first >= lowest && first + width - 1 <= highest) return;
  double sum = 0.0;
  for (int i = 0; i < width; ++i) {
    if (first + i < lowest || first + i > highest) w[i] = 0.0;
    sum += w[i];
  }
  for (int i = 0; i < width; ++i) w[i] /= sum;
}

template <int Dim, class Kernel>
void KernelMarkers<Dim, Kernel>::interpolate(std::initializer_list<Interpolation> wanted) const
{
  for (const Interpolation &one : wanted) one.values.resize(stencils_.size());
  for (std::size_t l = 0; l < stencils_.size(); ++l)
    for (const Interpolation &one : wanted)
      for (int c = 0; c < Dim; ++c) one.values[l][c] = sum_of(stencils_[l][c], one.faces[c].data());
}

template <int Dim, class Kernel>
void KernelMarkers<Dim, Kernel>::spread(std::initializer_list<Spreading> wanted, double density) const
{
  const double per_impulse = 1.0 / (density * grid_.cell_volume());
  for (std::size_t l = 0; l < stencils_.size(); ++l)
    for (int c = 0; c < Dim; ++c) {
      const Stencil &stencil = stencils_[l][c];
      for (const Spreading &one : wanted) {
        one.forcing.touch(stencil.first_plane, stencil.first_plane + width - 1);
        add_to(one.forcing.faces(c), stencil, per_impulse * one.impulses[l][c]);
      }
    }
}

template <int Dim, class Kernel> void KernelMarkers<Dim, Kernel>::interpolate(const Field<Dim> &cells, std::vector<double> &values) const
{
  values.resize(cell_stencils_.size());
  for (std::size_t l = 0; l < cell_stencils_.size(); ++l) values[l] = sum_of(cell_stencils_[l], cells.data());
}

template <int Dim, class Kernel> void KernelMarkers<Dim, Kernel>::spread(const std::vector<double> &amounts, Field<Dim> &cells) const
{
  for (std::size_t l = 0; l < cell_stencils_.size(); ++l) add_to(cells.data(), cell_stencils_[l], amounts[l] / grid_.cell_volume());
}

}  // namespace

template <int Dim>
std::unique_ptr<Markers<Dim>> make_markers(const std::string &kernel_name, const Grid<Dim> &grid, const Layout<Dim> &layout)
{
  if (kernel_name == "roma_1999") return std::make_unique<KernelMarkers<Dim, Roma1999>>(grid, layout);
  if (kernel_name == "peskin_2002") return std::make_unique<KernelMarkers<Dim, Peskin2002>>(grid, layout);
  if (kernel_name == "yang_2009") return std::make_unique<KernelMarkers<Dim, Yang2009>>(grid, layout);
  if (kernel_name == "gruninger_2025") return std::make_unique<KernelMarkers<Dim, Gruninger2025>>(grid, layout);
  throw std::invalid_argument("the kernel must be roma_1999, peskin_2002, yang_2009 or gruninger_2025, but is '" + kernel_name + "'");
}

template std::unique_ptr<Markers<2>> make_markers(const std::string &, const Grid<2> &, const Layout<2> &);
template std::unique_ptr<Markers<3>> make_markers(const std::string &, const Grid<3> &, const Layout<3> &);

}  // namespace swellflow
