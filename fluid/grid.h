// The uniform Cartesian grid and its cut into slabs: one slab of planes a rank, across the last direction.
#pragma once

#include <mpi.h>

#include <array>
#include <stdexcept>
#include <string>

namespace swellflow {

template <int Dim> using Vec = std::array<double, Dim>;

/// Grid of cubic cells of edge h. A plane is the set of cells that share an index in the last direction (in 2-D: a row);
/// this rank owns the planes first_plane … first_plane + planes - 1.
template <int Dim> struct Grid {
  static constexpr int last = Dim - 1;
  /// Planes that a rank sees of its neighbours: the support of a delta kernel on faces, two cells.
  static constexpr int ghost = 2;

  std::array<int, Dim> cells;
  Vec<Dim> origin;  ///< lower corner
  double h;
  MPI_Comm comm;
  std::array<bool, Dim> periodic;
  int rank = 0, ranks = 1;
  int first_plane = 0, planes = 0;

  /// Throws std::invalid_argument (on every rank alike) when a slab would be thinner than the ghost planes it hands out.
  Grid(std::array<int, Dim> cells_, Vec<Dim> origin_, double h_, MPI_Comm comm_, std::array<bool, Dim> periodic_ = {})
      : cells(cells_), origin(origin_), h(h_), comm(comm_), periodic(periodic_)
  {
    MPI_Comm_rank(comm, &rank);
    MPI_Comm_size(comm, &ranks);
    first_plane = first_plane_of(rank);
    planes = first_plane_of(rank + 1) - first_plane;
    if (cells[last] < ghost * ranks)
      throw std::invalid_argument("the fluid's slabs need at least " + std::to_string(ghost) + " planes of cells a rank, but " +
                                  std::to_string(cells[last]) + " planes were given to " + std::to_string(ranks) +
                                  " ranks; use fewer ranks or more cells");
  }

  int first_plane_of(int r) const { return static_cast<int>(static_cast<long>(cells[last]) * r / ranks); }

  /// The rank whose slab holds a plane of the whole grid.
  int rank_of_plane(int plane) const
  {
    int r = static_cast<int>(static_cast<long>(plane) * ranks / cells[last]);
    while (r + 1 < ranks && first_plane_of(r + 1) <= plane) ++r;
    while (first_plane_of(r) > plane) --r;
    return r;
  }

  /// Whether this rank's slab ends at a side of the box: never in a periodic direction.
  bool at_lower_end() const { return rank == 0 && !periodic[last]; }
  bool at_upper_end() const { return rank == ranks - 1 && !periodic[last]; }
  /// Itself where a single rank is periodic.
  int rank_below() const { return at_lower_end() ? MPI_PROC_NULL : (rank + ranks - 1) % ranks; }
  int rank_above() const { return at_upper_end() ? MPI_PROC_NULL : (rank + 1) % ranks; }
  double cell_volume() const
  {
    double volume = 1.0;
    for (int d = 0; d < Dim; ++d) volume *= h;
    return volume;
  }
};

}  // namespace swellflow
