// The markers on this rank's slab: interpolation of face velocities to them, and its adjoint, spreading.
#pragma once

#include <initializer_list>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "fluid/face_forcing.h"

namespace swellflow {

/// Both operators use the same weights, products of a one-dimensional kernel on the faces of each velocity component, or on the cells. Points beyond a wall, and faces on it
/// whose velocity is given, take no part: the weights of the others are scaled to sum to 1, for both operators and all kernels alike. In a periodic
/// direction nothing is left out: the weights reach into ghost cells.
///
/// No kernel reaches further than Grid::ghost = 2 planes beyond the slab that holds the marker. In units of h from the slab's lower end, a marker at 0 <= y < planes
/// has y or y - 1/2 among the points of a component, so a kernel of width 4 has its points from floor(y - 1/2) - 1 >= -2 to
/// floor(y) + 2 <= planes + 1; of width 3, from -1 to planes + 1. The same holds for the cells along any other direction.
template <int Dim> class Markers {
public:
  virtual ~Markers() = default;

  /// Positions within this rank's slab. One beyond a wall is taken as lying on the wall; in a periodic direction any image of the position will do.
  virtual void place(std::span<const Vec<Dim>> positions) = 0;
  virtual int size() const = 0;

  struct Interpolation {
    const VectorField<Dim> &faces;
    std::vector<Vec<Dim>> &values;
  };
  struct Spreading {
    std::span<const Vec<Dim>> impulses;
    FaceForcing<Dim> &forcing;
  };

  /// U_l = sum over faces of w_l F. Ghost planes and the ghost cells of periodic directions must be right. Several in one pass over the weights, which fit into no cache.
  virtual void interpolate(std::initializer_list<Interpolation> wanted) const = 0;
  void interpolate(const VectorField<Dim> &faces, std::vector<Vec<Dim>> &values) const { interpolate({{faces, values}}); }

  /// Adds to each face the change of velocity w_l J_l / (rho h^Dim) that impulses J [mass length / time] on the markers give. Several in one pass.
  virtual void spread(std::initializer_list<Spreading> wanted, double density) const = 0;
  void spread(std::span<const Vec<Dim>> impulses, double density, FaceForcing<Dim> &forcing) const { spread({{impulses, forcing}}, density); }

  /// The same for values in the cells, at the positions of the last `place_in_cells`.
  virtual void place_in_cells(std::span<const Vec<Dim>> positions) = 0;
  virtual void interpolate(const Field<Dim> &cells, std::vector<double> &values) const = 0;
  /// Adds to each cell w_l a_l / h^Dim.
  virtual void spread(const std::vector<double> &amounts, Field<Dim> &cells) const = 0;

  /// beta of the kernel (see delta_kernel.h): what comes back of a velocity that is spread from markers a cell apart. Forcing is divided by it.
  virtual double scale() const = 0;
  /// By how many cells markers lie inside the outline of a body for the flow around it to be that around the outline (see delta_kernel.h).
  virtual double retraction() const = 0;
};

/// Markers with the kernel of that name: roma_1999, peskin_2002, yang_2009 or gruninger_2025. Throws std::invalid_argument on any other.
template <int Dim>
std::unique_ptr<Markers<Dim>> make_markers(const std::string &kernel_name, const Grid<Dim> &grid, const Layout<Dim> &layout);

}  // namespace swellflow
