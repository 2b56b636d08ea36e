// When every rank has failed, exactly one is told to print.
#include <gtest/gtest.h>
#include <mpi.h>

#include "coupling/failure.h"

TEST(Failure, OneRankPrintsWhenAllFail)
{
  const int prints = swellflow::agree_on_failure(MPI_COMM_WORLD, "every rank failed");
  int printers = 0;
  MPI_Allreduce(&prints, &printers, 1, MPI_INT, MPI_SUM, MPI_COMM_WORLD);
  EXPECT_EQ(printers, 1);
}
