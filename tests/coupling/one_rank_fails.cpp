// A failure on one rank, while the others wait for it in MPI, ends them all.
#include <mpi.h>

#include "coupling/failure.h"

int main(int argc, char **argv)
{
  MPI_Init(&argc, &argv);
  MPI_Comm failures;
  MPI_Comm_dup(MPI_COMM_WORLD, &failures);
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  if (rank == 1) swellflow::agree_on_failure(failures, "only this rank failed");
  MPI_Barrier(MPI_COMM_WORLD);
  MPI_Finalize();
  return 0;
}
