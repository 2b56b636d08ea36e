// How the program ends when our own code throws.
#include "failure.h"

#include <chrono>
#include <cstdio>
#include <new>
#include <stdexcept>
#include <thread>
#include <typeinfo>

namespace swellflow {

std::string message_of(const std::exception &error, const std::string &command)
{
  const std::string place = command.empty() ? "" : command + ": ";
  if (dynamic_cast<const std::bad_alloc *>(&error) || dynamic_cast<const std::length_error *>(&error))
    return place + "all must fit into the memory, but a rank got no more of it: use fewer cells or objects, or more machines";
  // No words of ours: LIGGGHTS reads behind the end of a line of its own.
  if (typeid(error) == typeid(std::logic_error) || typeid(error) == typeid(std::out_of_range))
    return place + "the line must have all its words, but LIGGGHTS lacks one (" + error.what() + "): compare it with the manual";
  return error.what();
}

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
