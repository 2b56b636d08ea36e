#include "complaints.h"
#include "liggghts_plugins/square_cells.h"

using namespace swellflow_test;
using swellflow::square_cells;

namespace {

std::string complaint(const std::array<double, 2> &length, double wanted)
{
  return complaint_of([&] { square_cells(length, wanted); });
}

}  // namespace

TEST(SquareCells, FillTheBoxAndAreNearest)
{
  EXPECT_EQ(square_cells({2.0, 6.0}, 0.25 / 12), (std::array{96, 288}));
  EXPECT_EQ(square_cells({1.0, 1.0}, 0.012), (std::array{83, 83}));
  EXPECT_EQ(square_cells({0.3, 0.2}, 0.0109), (std::array{27, 18}));   // 27.5 are wanted: 27 x 18 is nearer than 30 x 20
  EXPECT_EQ(square_cells({0.7, 1.1}, 0.1), (std::array{7, 11}));
  EXPECT_EQ(square_cells({1.0, 1.0}, 0.23), (std::array{4, 4}));       // there are at least 4
}

TEST(SquareCells, AreRefusedWithWhatWouldFit)
{
  expect_all(complaint({1.0, 0.777}, 0.1), {"must be square", "about 0.1", "1 x 0.777", "make it 1 x 0.8", "10 x 8 cells", "cells NX NY"});
  expect_all(complaint({1.0, 1.0}, 0.5), {"must be 4 to 46340 cells", "about 0.5", "would be 2 along 1", "cells NX NY"});
  expect_all(complaint({1.0, 3.0}, 1e-5), {"must be 4 to 46340 cells", "would be 1e+05 along 1", "cells NX NY"});
}

TEST(SquareCells, FewOfThemThatFitAreTakenWhenTheyAreNear)
{
  EXPECT_EQ(square_cells({1.1, 1.3}, 0.11), (std::array{11, 13}));     // 10 are wanted
  expect_all(complaint({1.1, 1.3}, 0.07), {"make it 1.1 x 1.30625", "16 x 19 cells"});
}
