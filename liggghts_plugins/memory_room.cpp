#include "memory_room.h"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>

#include "options.h"

namespace swellflow {

namespace {

constexpr double gigabyte = 1e9;

}  // namespace

double memory_of_a_rank(MPI_Comm world)
{
  MPI_Comm machine;
  int ranks_here = 1;
  MPI_Comm_split_type(world, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &machine);
  MPI_Comm_size(machine, &ranks_here);
  MPI_Comm_free(&machine);
  double bytes = static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE)) / ranks_here;
  rlimit limit{};
  if (getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY) bytes = std::min(bytes, static_cast<double>(limit.rlim_cur));
  MPI_Allreduce(MPI_IN_PLACE, &bytes, 1, MPI_DOUBLE, MPI_MIN, world);
  return bytes;
}

void require_memory(MPI_Comm world, const std::string &place, const std::string &what, double bytes)
{
  int ranks;
  MPI_Comm_size(world, &ranks);
  const double there_is = ranks * memory_of_a_rank(world);
  if (bytes <= there_is) return;
  throw OptionError(place + ": " + what + " must fit into the memory, but they need " + rounded(bytes / gigabyte) + " GB, and there are " + rounded(there_is / gigabyte) +
                    ": ask for fewer, or for more machines");
}

}  // namespace swellflow
