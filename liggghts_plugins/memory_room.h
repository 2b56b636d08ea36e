// What does not fit into the memory is refused before it is asked for: a machine without memory left ends programs without a word.
#pragma once

#include <mpi.h>

#include <string>

namespace swellflow {

/// Bytes that a rank may use: the limit that was set for it (ulimit -v), or its share of the machine's memory. Collective.
double memory_of_a_rank(MPI_Comm world);

/// Throws OptionError, on all ranks alike, when `what` needs more than that: `bytes` on all ranks together. Collective.
void require_memory(MPI_Comm world, const std::string &place, const std::string &what, double bytes);

}  // namespace swellflow
