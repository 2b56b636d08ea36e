#include "fluid/markers.h"

#include <cassert>

#include "fluid/delta_kernel.h"

namespace swellflow {

namespace {

template <int Dim, class Kernel> class KernelMarkers final : public Markers<Dim> {
public:
  KernelMarkers(const Grid<Dim> &grid, const Layout<Dim> &layout) : grid_(grid), layout_(layout) {}

  void place(const std::vector<Vec<Dim>> &positions) override;
  int size() const override { return static_cast<int>(stencils_.size()); }
  using typename Markers<Dim>::Interpolation;
  using typename Markers<Dim>::Spreading;
  using Markers<Dim>::interpolate;
  using Markers<Dim>::spread;
  void interpolate(std::initializer_list<Interpolation> wanted) const override;
  void spread(std::initializer_list<Spreading> wanted, double density) const override;
  void place_in_cells(const std::vector<Vec<Dim>> &positions) override;
  void interpolate(const Field<Dim> &cells, std::vector<double> &values) const override;
  void spread(const std::vector<double> &amounts, Field<Dim> &cells) const override;
  double scale() const override { return Kernel::scale; }
  double retraction() const override { return Kernel::retraction; }

private:
  static constexpr int width = Kernel::width;
  static constexpr int centres = Dim;  // in the place of a component: of the cells
  struct Stencil {
    std::ptrdiff_t first;  // the lowest point of the support
    int first_plane;
    std::array<std::array<double, width>, Dim> weight;  // by direction, point
  };

  Vec<Dim> in_cells(const Vec<Dim> &position) const;
  static void weigh(bool along, double r, double *w)
  {
    if constexpr (!requires { typename Kernel::Across; }) Kernel::weights(r, w);
    else if (along) Kernel::Along::weights(r, w);
    else Kernel::Across::weights(r, w);
  }
  Stencil stencil_of(const Vec<Dim> &x, int c) const;
  static void leave_out_walls(int first, int lowest, int highest, std::array<double, width> &w);

  template <class Visit> void each_point(const Stencil &stencil, Visit &&visit) const
  {
    const auto &w = stencil.weight;
    if constexpr (Dim == 2) {
      for (int j = 0; j < width; ++j)
        for (int i = 0; i < width; ++i) visit(stencil.first + j * layout_.stride(1) + i, w[1][j] * w[0][i]);
    } else {
      for (int k = 0; k < width; ++k)
        for (int j = 0; j < width; ++j)
          for (int i = 0; i < width; ++i)
            visit(stencil.first + k * layout_.stride(2) + j * layout_.stride(1) + i, w[2][k] * w[1][j] * w[0][i]);
    }
  }

  const Grid<Dim> &grid_;
  const Layout<Dim> &layout_;
  std::vector<std::array<Stencil, Dim>> stencils_;  // by component
  std::vector<Stencil> cell_stencils_;
};

template <int Dim, class Kernel> void KernelMarkers<Dim, Kernel>::place(const std::vector<Vec<Dim>> &positions)
{
  stencils_.resize(positions.size());
  for (std::size_t l = 0; l < positions.size(); ++l) {
    const Vec<Dim> x = in_cells(positions[l]);
    for (int c = 0; c < Dim; ++c) stencils_[l][c] = stencil_of(x, c);
  }
}

template <int Dim, class Kernel> void KernelMarkers<Dim, Kernel>::place_in_cells(const std::vector<Vec<Dim>> &positions)
{
  cell_stencils_.resize(positions.size());
  for (std::size_t l = 0; l < positions.size(); ++l) cell_stencils_[l] = stencil_of(in_cells(positions[l]), centres);
}

/// In units of h from the box's lower corner; in a periodic direction of all images that nearest to the middle of the slab.
template <int Dim, class Kernel> Vec<Dim> KernelMarkers<Dim, Kernel>::in_cells(const Vec<Dim> &position) const
{
  Vec<Dim> result;
  for (int d = 0; d < Dim; ++d) {
    const double size = grid_.cells[d], x = (position[d] - grid_.origin[d]) / grid_.h;
    const double middle = (d == Grid<Dim>::last ? grid_.first_plane : 0) + 0.5 * layout_.cells(d);
    result[d] = grid_.periodic[d] ? x - size * std::floor((x - middle) / size + 0.5) : std::clamp(x, 0.0, size);
  }
  return result;
}

/// Of a velocity component, or `centres`.
template <int Dim, class Kernel>
typename KernelMarkers<Dim, Kernel>::Stencil KernelMarkers<Dim, Kernel>::stencil_of(const Vec<Dim> &x, int c) const
{
  Stencil stencil;
  constexpr int ghost = Grid<Dim>::ghost;
  std::array<int, Dim> first;
  for (int d = 0; d < Dim; ++d) {
    // Faces of component c lie at whole numbers in direction c, at half ones in the others; cells at half ones in all.
    const double y = x[d] - (d == c ? 0.0 : 0.5);
    const int begin = d == Grid<Dim>::last ? grid_.first_plane : 0;
    const int anchor = static_cast<int>(std::floor(y + (width % 2 ? 0.5 : 0.0)));
    // A marker on the upper end of its slab, or beyond by rounding, has the points of one just below.
    const int lowest = begin - ghost, highest = begin + layout_.cells(d) + ghost - width;
    first[d] = std::clamp(anchor - Kernel::anchor, lowest, highest);
    assert(std::abs(first[d] - (anchor - Kernel::anchor)) <= 1 && "a marker must lie in this rank's slab");
    auto &w = stencil.weight[d];
    weigh(d == c, y - (first[d] + Kernel::anchor), w.data());
    if (!grid_.periodic[d]) leave_out_walls(first[d], d == c ? 1 : 0, grid_.cells[d] - 1, w);
    first[d] -= begin;
  }
  stencil.first_plane = first[Dim - 1];
  stencil.first = layout_.at(first);
  return stencil;
}

/// Only the points lowest … highest of the box are the fluid's.
template <int Dim, class Kernel>
void KernelMarkers<Dim, Kernel>::leave_out_walls(int first, int lowest, int highest, std::array<double, width> &w)
{
  if (first >= lowest && first + width - 1 <= highest) return;
  double sum = 0.0;
  for (int i = 0; i < width; ++i) {
    if (first + i < lowest || first + i > highest) w[i] = 0.0;
    sum += w[i];
  }
  for (double &weight : w) weight /= sum;
}

template <int Dim, class Kernel>
void KernelMarkers<Dim, Kernel>::interpolate(std::initializer_list<Interpolation> wanted) const
{
  for (const Interpolation &one : wanted) one.values.resize(stencils_.size());
  for (std::size_t l = 0; l < stencils_.size(); ++l)
    for (const Interpolation &one : wanted)
      for (int c = 0; c < Dim; ++c) {
        const double *face = one.faces[c].data();
        double sum = 0.0;
        each_point(stencils_[l][c], [&](std::ptrdiff_t at, double weight) { sum += weight * face[at]; });
        one.values[l][c] = sum;
      }
}

template <int Dim, class Kernel>
void KernelMarkers<Dim, Kernel>::spread(std::initializer_list<Spreading> wanted, double density) const
{
  const double per_impulse = 1.0 / (density * grid_.cell_volume());
  for (std::size_t l = 0; l < stencils_.size(); ++l)
    for (const Spreading &one : wanted)
      for (int c = 0; c < Dim; ++c) {
        const double change = per_impulse * one.impulses[l][c];
        double *face = one.forcing.faces(c);
        one.forcing.touch(stencils_[l][c].first_plane, stencils_[l][c].first_plane + width - 1);
        each_point(stencils_[l][c], [&](std::ptrdiff_t at, double weight) { face[at] += weight * change; });
      }
}

template <int Dim, class Kernel> void KernelMarkers<Dim, Kernel>::interpolate(const Field<Dim> &cells, std::vector<double> &values) const
{
  values.resize(cell_stencils_.size());
  for (std::size_t l = 0; l < cell_stencils_.size(); ++l) {
    double sum = 0.0;
    each_point(cell_stencils_[l], [&](std::ptrdiff_t at, double weight) { sum += weight * cells[at]; });
    values[l] = sum;
  }
}

template <int Dim, class Kernel> void KernelMarkers<Dim, Kernel>::spread(const std::vector<double> &amounts, Field<Dim> &cells) const
{
  for (std::size_t l = 0; l < cell_stencils_.size(); ++l) {
    const double change = amounts[l] / grid_.cell_volume();
    each_point(cell_stencils_[l], [&](std::ptrdiff_t at, double weight) { cells[at] += weight * change; });
  }
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
