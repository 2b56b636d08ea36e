// How the program ends when our own code throws.
#include "failure.h"

#include <chrono>
#include <cstdio>
#include <thread>

namespace swellflow {

bool agree_on_failure(MPI_Comm comm, const std::string &message)
{
  using namespace std::chrono_literals;
  int rank = 0, done = 0;
  MPI_Comm_rank(comm, &rank);
  MPI_Request all_failed;
  MPI_Ibarrier(comm, &all_failed);
  const auto patience = std::chrono::steady_clock::now() + 5s;
  while (!done && std::chrono::steady_clock::now() < patience) {
    MPI_Test(&all_failed, &done, MPI_STATUS_IGNORE);
    if (!done) std::this_thread::sleep_for(1ms);
  }
  if (!done) {
    std::fprintf(stderr, "ERROR on rank %d: %s\n", rank, message.c_str());
    MPI_Abort(comm, 1);
  }
  return rank == 0;
}

}  // namespace swellflow
