// Springs of a ring with a hub: Newton's third law, restitution, and the modes of the linearised object.
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <vector>

#include "liggghts_plugins/objects/springs.h"

using namespace swellflow;
using std::numbers::pi;

namespace {

/// Positions of ring points 0 .. N-1 and the hub, N, as one vector.
Eigen::VectorXd rest_shape(const Disk &disk)
{
  Eigen::VectorXd X = Eigen::VectorXd::Zero(2 * (disk.ring_points + 1));
  for (int k = 0; k < disk.ring_points; ++k) X.segment<2>(2 * k) = disk.ring_point(k);
  return X;
}

Eigen::VectorXd forces(const Disk &disk, const Eigen::VectorXd &X)
{
  const int N = disk.ring_points;
  Eigen::VectorXd F = Eigen::VectorXd::Zero(X.size());
  for_each_spring(N, [&](int a, int b, bool is_spoke) {
    const int other = b < 0 ? N : b;
    const double L = is_spoke ? disk.spoke_length() : disk.ring_spring_length();
    const Vector2 f = spring_force(X.segment<2>(2 * a), X.segment<2>(2 * other), L, 1.0);
    F.segment<2>(2 * a) += f;
    F.segment<2>(2 * other) -= f;
  });
  return F;
}

/// -dF/dX about the shape at rest by central differences.
Eigen::MatrixXd stiffness_matrix(const Disk &disk)
{
  const Eigen::VectorXd X = rest_shape(disk);
  const double h = 1e-6;
  Eigen::MatrixXd K(X.size(), X.size());
  for (int j = 0; j < X.size(); ++j) {
    Eigen::VectorXd forward = X, backward = X;
    forward[j] += h, backward[j] -= h;
    K.col(j) = -(forces(disk, forward) - forces(disk, backward)) / (2 * h);
  }
  return K;
}

std::vector<double> eigenvalues_with_hub_held(int N)
{
  const Eigen::MatrixXd K = stiffness_matrix({.diameter = 1.0, .ring_points = N, .density = 1.0});
  const Eigen::VectorXd values = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(K.topLeftCorner(2 * N, 2 * N)).eigenvalues();
  return {values.begin(), values.end()};
}

/// lambda/k of mode n, hub held, ring and spokes of stiffness k:
/// [T -+ sqrt(T^2 - 16 cos^2(a) sin^2(n a))] / 2, T = 1 + 4 q_n, q_n = sin^2(a) cos^2(n a) + cos^2(a) sin^2(n a), a = pi/N.
double mode(int N, int n, int sign)
{
  const double a = pi / N;
  const double q = std::pow(std::sin(a) * std::cos(n * a), 2) + std::pow(std::cos(a) * std::sin(n * a), 2);
  const double T = 1 + 4 * q, root = T * T - 16 * std::pow(std::cos(a) * std::sin(n * a), 2);
  return 0.5 * (T + sign * std::sqrt(std::max(root, 0.0)));
}

double distance_to_nearest(const std::vector<double> &values, double wanted)
{
  double nearest = 1e300;
  for (double value : values) nearest = std::min(nearest, std::abs(value - wanted));
  return nearest;
}

/// Largest omega^2 of the free object for k = 1.
double true_largest_omega_squared(const Disk &disk)
{
  const int N = disk.ring_points;
  Eigen::VectorXd root(2 * (N + 1));
  root.setConstant(1 / std::sqrt(disk.ring_point_mass()));
  root.tail<2>().setConstant(1 / std::sqrt(disk.hub_mass()));
  const Eigen::MatrixXd A = root.asDiagonal() * stiffness_matrix(disk) * root.asDiagonal();
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(A).eigenvalues().maxCoeff();
}

}  // namespace

class Modes : public testing::TestWithParam<int> {};

TEST_P(Modes, OfTheForceKernelAreTheAnalyticOnes)
{
  const int N = GetParam();
  std::vector<double> expected;
  for (int n = 0; n <= N / 2; ++n)
    for (int sign : {-1, 1})
      for (int copy = 0; copy < (n == 0 || 2 * n == N ? 1 : 2); ++copy) expected.push_back(mode(N, n, sign));
  std::sort(expected.begin(), expected.end());
  const std::vector<double> found = eigenvalues_with_hub_held(N);
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t k = 0; k < found.size(); ++k) EXPECT_NEAR(found[k], expected[k], 1e-8) << "N = " << N << ", number " << k;
}

INSTANTIATE_TEST_SUITE_P(Springs, Modes, testing::Values(10, 20, 21, 70));

TEST(Springs, ModesHaveTheTabulatedValues)
{
  // Printed to six digits by an independent computation of the same formula.
  struct { int N, n; double low, high; } table[] = {
      {10, 2, 0.690983, 1.809017}, {10, 5, 1.000000, 3.618034}, {20, 1, 0.086455, 1.104528}, {20, 4, 0.879690, 1.532524},
      {20, 10, 1.000000, 3.902113}, {21, 3, 0.619074, 1.189347}, {21, 10, 0.999828, 3.889971}, {70, 10, 0.733515, 1.024526},
      {70, 35, 1.000000, 3.991949}};
  for (const auto &[N, n, low, high] : table) {
    const std::vector<double> found = eigenvalues_with_hub_held(N);
    EXPECT_LT(distance_to_nearest(found, low), 1e-6) << "N = " << N << ", n = " << n;
    EXPECT_LT(distance_to_nearest(found, high), 1e-6) << "N = " << N << ", n = " << n;
  }
}

TEST(Springs, TheStepLimitIsSafeAndNotFarFromTheTrueOne)
{
  for (int N : {3, 4, 5, 10, 20, 70})
    for (MassShare share : {MassShare::hub_half, MassShare::equal}) {
      const Disk disk{.diameter = 1.0, .ring_points = N, .density = 1.0, .share = share};
      const double estimate = largest_omega_squared(1.0, N, disk.ring_point_mass(), disk.hub_mass());
      const double exact = true_largest_omega_squared(disk);
      EXPECT_GE(estimate, exact * (1 - 1e-8)) << N;
      EXPECT_LE(estimate, 1.6 * exact) << N;
    }
}

TEST(Springs, ForcesAreOppositeAndAlongTheSpring)
{
  const Vector2 A(0.3, -0.2), B(1.1, 0.4), U(0.7, 0.1), W(-0.2, 0.5), d = A - B;
  const Vector2 spring = spring_force(A, B, 0.8, 3.0), dashpot = dashpot_force(A, B, U, W, 0.7);
  EXPECT_EQ(spring, -spring_force(B, A, 0.8, 3.0));
  EXPECT_EQ(dashpot, -dashpot_force(B, A, W, U, 0.7));
  EXPECT_NEAR(spring.x() * d.y() - spring.y() * d.x(), 0.0, 1e-15);
  EXPECT_NEAR(dashpot.x() * d.y() - dashpot.y() * d.x(), 0.0, 1e-15);
}

TEST(Springs, PullBackAndPushApart)
{
  EXPECT_EQ(spring_force({1.5, 0}, {0, 0}, 1.0, 2.0), Vector2(-1.0, 0.0));
  EXPECT_EQ(spring_force({0.5, 0}, {0, 0}, 1.0, 2.0), Vector2(1.0, 0.0));
}

TEST(Springs, ADashpotOpposesTheClosingSpeedOnly)
{
  const Vector2 A(0, 0), B(1, 0);
  EXPECT_EQ(dashpot_force(A, B, Vector2(-1, 0), Vector2(1, 0), 1.5), Vector2(3, 0)) << "opening";
  EXPECT_EQ(dashpot_force(A, B, Vector2(1, 0), Vector2(-1, 0), 1.5), Vector2(-3, 0)) << "closing";
  EXPECT_EQ(dashpot_force(A, B, Vector2(0, 1), Vector2(0, -1), 1.5).norm(), 0.0) << "turning";
}

TEST(Springs, PointsOnOneSpotGiveNoForce)
{
  const Vector2 A(0.5, 0.5);
  EXPECT_EQ(spring_force(A, A, 0.8, 3.0).norm(), 0.0);
  EXPECT_EQ(dashpot_force(A, A, Vector2(1, 0), Vector2(0, 1), 0.7).norm(), 0.0);
}

TEST(Springs, BondedPairKeepsTheAskedRestitution)
{
  for (double e : {0.1, 0.5, 0.9, 1.0}) {
    const double m_a = 2.0, m_b = 0.5, dt = 1e-5;
    const SpringLaw law{.stiffness = 100.0, .damping = damping_ratio(e)};
    const double c = law.dashpot(m_a, m_b);
    Vector2 A(0, 0), B(1, 0), U(1, 0), W(-3, 0);
    do {  // until the spring is as long as at rest again
      const Vector2 F = spring_force(A, B, 1.0, law.stiffness) + dashpot_force(A, B, U, W, c);
      U += dt / m_a * F, W -= dt / m_b * F;
      A += dt * U, B += dt * W;
    } while ((B - A).x() < 1.0);
    EXPECT_NEAR((W - U).x() / 4.0, e, 2e-4);
    EXPECT_NEAR(m_a * U.x() + m_b * W.x(), 2.0 - 1.5, 1e-9);
  }
}
