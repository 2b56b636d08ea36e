// The largest of something, and the object that has it.
#pragma once

#include <mpi.h>

#include <array>
#include <string>

namespace LAMMPS_NS {

/// Laid out as MPI_DOUBLE_INT. Of equal values that of the object with the lower number counts, as MPI_MAXLOC has it.
struct WorstObject {
  double value = 0.0;
  int object = 0;  ///< its number (molecule); 0: there is none

  void meet(double other, int of)
  {
    if (other > value || (other == value && of < object)) *this = {other, of};
  }
};

/// The largest of all ranks. Collective.
inline void agree_on_worst(MPI_Comm comm, WorstObject *worst, int n)
{
  MPI_Allreduce(MPI_IN_PLACE, worst, n, MPI_DOUBLE_INT, MPI_MAXLOC, comm);
}
template <std::size_t N>
void agree_on_worst(MPI_Comm comm, std::array<WorstObject, N> &worst)
{
  agree_on_worst(comm, worst.data(), N);
}

inline std::string name_of(int object) { return "object (molecule) " + std::to_string(object); }

}  // namespace LAMMPS_NS
