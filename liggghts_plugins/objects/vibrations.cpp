#include "vibrations.h"

#include <Eigen/Eigenvalues>
#include <algorithm>

#include "ring_solver.h"

namespace swellflow {

namespace {

/// Tension over length: a pull keeps points from moving sideways, a push helps them to.
double sideways_stiffness(const Vector2 &d, const Spring &spring)
{
  const double xi = d.norm();
  return xi > 0.0 ? spring.stiffness * (1.0 - spring.length / xi) : spring.stiffness;
}

}  // namespace

Eigen::MatrixXd stiffness_matrix(const std::vector<Vector2> &x, const SpringSet &springs, double dashpots_per_time)
{
  const int n = springs.held_points();
  Eigen::MatrixXd K = Eigen::MatrixXd::Zero(2 * n, 2 * n);
  for_each_spring(springs, [&](int a, int b, const Spring &spring) {
    const Vector2 d = x[a] - x[b], along = direction(x[a], x[b]);
    const double axial = spring.stiffness + dashpots_per_time * spring.dashpot, sideways = sideways_stiffness(d, spring);
    const Matrix2 block = sideways * Matrix2::Identity() + (axial - sideways) * along * along.transpose();
    for (const int i : {a, b}) K.block<2, 2>(2 * i, 2 * i) += block;
    K.block<2, 2>(2 * a, 2 * b) -= block;
    K.block<2, 2>(2 * b, 2 * a) -= block;
  });
  return K;
}

double step_over_limit(const std::vector<Vector2> &x, const std::vector<double> &mass, const SpringSet &springs, double dt)
{
  Eigen::MatrixXd K = stiffness_matrix(x, springs, 2.0 / dt);
  Eigen::VectorXd scale(K.rows());
  for (int i = 0; i < K.rows(); ++i) scale[i] = 1.0 / std::sqrt(mass[i / 2]);
  const Eigen::MatrixXd symmetric = scale.asDiagonal() * K * scale.asDiagonal();
  const double largest = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(symmetric, Eigen::EigenvaluesOnly).eigenvalues().maxCoeff();
  return 0.5 * dt * std::sqrt(std::max(0.0, largest));
}

double bound_of_step_over_limit(const std::vector<Vector2> &x, const std::vector<double> &mass, const SpringSet &springs, double dt)
{
  std::vector<double> sums(springs.held_points(), 0.0);
  for_each_spring(springs, [&](int a, int b, const Spring &spring) {
    const double strongest = std::max(spring.stiffness + 2.0 * spring.dashpot / dt, std::abs(sideways_stiffness(x[a] - x[b], spring)));
    sums[a] += 2.0 * strongest;
    sums[b] += 2.0 * strongest;
  });
  double largest = 0.0;
  for (std::size_t i = 0; i < sums.size(); ++i) largest = std::max(largest, sums[i] / mass[i]);
  return 0.5 * dt * std::sqrt(largest);
}

}  // namespace swellflow
