// How the program ends when our own code throws: one message, no rank left waiting, a non-zero exit.
#pragma once

#include <mpi.h>

#include <exception>
#include <string>

namespace swellflow {

/// What a user is told of an exception that came out of `command`: its own words, unless they are a library's.
std::string message_of(const std::exception &error, const std::string &command);

/// Each rank that failed calls this. True on one rank, which is to print the message, when every rank has failed. When
/// some ranks have not (they wait for the others in MPI), it prints the message itself and ends them all.
bool agree_on_failure(MPI_Comm comm, const std::string &message);

}  // namespace swellflow
