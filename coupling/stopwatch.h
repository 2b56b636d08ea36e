// Wall time spent in a scope.
#pragma once

#include <mpi.h>

namespace swellflow {

/// Adds the time of its life to `seconds`.
class Stopwatch {
public:
  explicit Stopwatch(double &seconds) : seconds_(seconds), start_(MPI_Wtime()) {}
  ~Stopwatch() { seconds_ += MPI_Wtime() - start_; }
  Stopwatch(const Stopwatch &) = delete;
  Stopwatch &operator=(const Stopwatch &) = delete;

private:
  double &seconds_;
  double start_;
};

}  // namespace swellflow
