// When every rank has failed, exactly one is told to print.
#include <gtest/gtest.h>
#include <mpi.h>

#include <new>
#include <stdexcept>

#include "coupling/failure.h"

TEST(Failure, WhatALibraryThrowsGetsWordsForUsers)
{
  const auto message = [](const std::exception &error) { return swellflow::message_of(error, "pair_style"); };
  EXPECT_EQ(message(std::runtime_error("our own words")), "our own words");
  EXPECT_EQ(message(std::invalid_argument("our own words")), "our own words");
  EXPECT_NE(message(std::bad_alloc()).find("pair_style: all must fit into the memory"), std::string::npos);
  EXPECT_NE(message(std::length_error("vector::_M_default_append")).find("must fit into the memory"), std::string::npos);
  EXPECT_NE(message(std::logic_error("basic_string: construction from null is not valid")).find("pair_style: the line must have all its words"), std::string::npos);
}

TEST(Failure, OneRankPrintsWhenAllFail)
{
  const int prints = swellflow::agree_on_failure(MPI_COMM_WORLD, "every rank failed");
  int printers = 0;
  MPI_Allreduce(&prints, &printers, 1, MPI_INT, MPI_SUM, MPI_COMM_WORLD);
  EXPECT_EQ(printers, 1);
}
