// Agreement of all ranks on success or failure.
#include "collective.h"

#include <stdexcept>
#include <string>

namespace swellflow {

void all_or_none(MPI_Comm comm, const std::function<void()> &work)
{
  std::string message;
  try {
    work();
  } catch (const std::exception &failure) {
    message = failure.what();
    if (message.empty()) message = "unknown failure";
  }
  int rank, size;
  MPI_Comm_rank(comm, &rank);
  MPI_Comm_size(comm, &size);
  int first = message.empty() ? size : rank;
  MPI_Allreduce(MPI_IN_PLACE, &first, 1, MPI_INT, MPI_MIN, comm);
  if (first == size) return;
  int length = static_cast<int>(message.size());
  MPI_Bcast(&length, 1, MPI_INT, first, comm);
  message.resize(length);
  MPI_Bcast(message.data(), length, MPI_CHAR, first, comm);
  throw std::runtime_error(message);
}

void on_rank_0(MPI_Comm comm, const std::function<void()> &work)
{
  int rank;
  MPI_Comm_rank(comm, &rank);
  all_or_none(comm, [&] {
    if (rank == 0) work();
  });
}

}  // namespace swellflow
