// Linear systems of a ring with a hub, against a dense solver.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <random>

#include "liggghts_plugins/objects/ring_solver.h"

using namespace swellflow;

TEST(RingSolver, SolvesWhatADenseSolverSolves)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  for (int n : {3, 4, 5, 20, 71})
    for (bool hub : {false, true}) {
      const int size = 2 * (n + hub);
      Eigen::MatrixXd A = Eigen::MatrixXd::Zero(size, size);
      RingSolver solver;
      solver.start(n, hub);
      const auto couple = [&](int a, int b) {
        Matrix2 block;
        for (double &value : block.reshaped()) value = uniform(random);
        solver.coupling(a, b) += block;
        A.block<2, 2>(2 * a, 2 * b) += block;
        A.block<2, 2>(2 * b, 2 * a) += block.transpose();
      };
      for (int k = 0; k < n; ++k) {
        couple(k, (k + 1) % n);
        if (hub) couple(k, n);
      }
      Eigen::VectorXd r(size);
      for (int i = 0; i < n + hub; ++i) {
        const Matrix2 block = (i == n ? 3.0 * n : 9.0) * Matrix2::Identity();
        solver.diagonal(i) += block;
        A.block<2, 2>(2 * i, 2 * i) += block;
        r.segment<2>(2 * i) = solver.right_side(i) = Vector2(uniform(random), uniform(random));
      }
      ASSERT_TRUE(solver.solve());
      const Eigen::VectorXd x = A.ldlt().solve(r);
      for (int i = 0; i < n + hub; ++i) EXPECT_LT((solver.solution(i) - Vector2(x.segment<2>(2 * i))).norm(), 1e-13) << n << " points, point " << i;
    }
}

TEST(RingSolver, RefusesAnIndefiniteMatrix)
{
  for (int bad : {0, 1, 3, 4}) {
    RingSolver solver;
    solver.start(4, true);
    for (int i = 0; i < 5; ++i) solver.diagonal(i) = (i == bad ? -1.0 : 1.0) * Matrix2::Identity();
    EXPECT_FALSE(solver.solve()) << bad;
  }
}
