// Work that may fail on one rank only (a full disk, a folder without rights) must end alike on all of them.
#pragma once

#include <mpi.h>

#include <functional>

namespace swellflow {

/// Runs `work`; if it throws on any rank, every rank throws std::runtime_error with the message of the lowest that failed.
void all_or_none(MPI_Comm comm, const std::function<void()> &work);

/// The same, with the work done by rank 0 alone.
void on_rank_0(MPI_Comm comm, const std::function<void()> &work);

}  // namespace swellflow
