// What all ranks hold, together.
#pragma once

#include <mpi.h>

#include <type_traits>
#include <vector>

namespace LAMMPS_NS {

/// The parts of all ranks, in their order, on every rank. Collective.
template <typename T>
std::vector<T> from_all_ranks(const std::vector<T> &own, MPI_Comm world)
{
  static_assert(std::is_trivially_copyable_v<T>);
  int ranks, size = own.size();
  MPI_Comm_size(world, &ranks);
  std::vector<int> sizes(ranks), offsets(ranks, 0);
  MPI_Allgather(&size, 1, MPI_INT, sizes.data(), 1, MPI_INT, world);
  for (int rank = 1; rank < ranks; rank++) offsets[rank] = offsets[rank - 1] + sizes[rank - 1];
  std::vector<T> all(offsets.back() + sizes.back());
  MPI_Datatype record;
  MPI_Type_contiguous(sizeof(T), MPI_BYTE, &record);
  MPI_Type_commit(&record);
  MPI_Allgatherv(own.data(), size, record, all.data(), sizes.data(), offsets.data(), record, world);
  MPI_Type_free(&record);
  return all;
}

}  // namespace LAMMPS_NS
