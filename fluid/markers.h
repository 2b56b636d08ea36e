// The markers on this rank's slab: interpolation of face velocities to them, and its adjoint, spreading.
#pragma once

#include <vector>

#include "fluid/delta_kernel.h"
#include "fluid/face_forcing.h"

namespace swellflow {

/// Both operators use the same weights, products of a one-dimensional kernel on the faces of each velocity component. Points beyond a wall, and faces on it
/// whose velocity is given, take no part: the weights of the others are scaled to sum to 1, for both operators alike.
template <int Dim, class Kernel = Roma1999> class Markers {
public:
  Markers(const Grid<Dim> &grid, const Layout<Dim> &layout) : grid_(grid), layout_(layout) {}

  /// Positions within this rank's slab (one beyond a wall is taken as lying on the wall).
  void place(const std::vector<Vec<Dim>> &positions);
  int size() const { return static_cast<int>(stencils_.size()); }

  /// U_l = sum over faces of w_l F.
  void interpolate(const VectorField<Dim> &face_velocity, std::vector<Vec<Dim>> &velocities) const;

  /// Adds to each face the change of velocity w_l J_l / (rho h^Dim) that impulses J [mass length / time] on the markers give.
  void spread(const std::vector<Vec<Dim>> &impulses, double density, FaceForcing<Dim> &forcing) const;

private:
  static constexpr int width = Kernel::width;
  struct Stencil {
    std::array<std::ptrdiff_t, Dim> first;             // by component: the lowest point of the support
    std::array<int, Dim> first_plane;
    std::array<std::array<std::array<double, width>, Dim>, Dim> weight;  // by component, direction, point
  };
  void place_component(const Vec<Dim> &position, int c, Stencil &stencil) const;

  template <class Visit> void each_point(const Stencil &stencil, int c, Visit &&visit) const
  {
    const auto &w = stencil.weight[c];
    if constexpr (Dim == 2) {
      for (int j = 0; j < width; ++j)
        for (int i = 0; i < width; ++i) visit(stencil.first[c] + j * layout_.stride(1) + i, w[1][j] * w[0][i]);
    } else {
      for (int k = 0; k < width; ++k)
        for (int j = 0; j < width; ++j)
          for (int i = 0; i < width; ++i)
            visit(stencil.first[c] + k * layout_.stride(2) + j * layout_.stride(1) + i, w[2][k] * w[1][j] * w[0][i]);
    }
  }

  const Grid<Dim> &grid_;
  const Layout<Dim> &layout_;
  std::vector<Stencil> stencils_;
};

extern template class Markers<2>;

}  // namespace swellflow
