// Springs of a ring with a hub: Newton's third law, restitution, and the modes of the linearised object.
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <numeric>
#include <vector>

#include "liggghts_plugins/objects/spring_forces.h"
#include "liggghts_plugins/objects/vibrations.h"
#include "ring_object.h"

using namespace swellflow;
using namespace swellflow_test;
using std::numbers::pi;

namespace {

std::vector<Vector2> forces(const std::vector<Vector2> &x, const SpringSet &springs)
{
  std::vector<Vector2> F(x.size(), Vector2::Zero());
  for_each_spring(springs, [&](int a, int b, const Spring &spring) {
    const Vector2 f = spring_force({x[a], x[b]}, spring.length, spring.stiffness);
    F[a] += f;
    F[b] -= f;
  });
  return F;
}

std::vector<Vector2> dashpot_forces(const PointBody &body, const SpringSet &springs)
{
  std::vector<Vector2> F(body.x.size(), Vector2::Zero());
  for_each_spring(springs, [&](int a, int b, const Spring &spring) {
    const Vector2 f = dashpot_force({body.x[a], body.x[b]}, body.v[a] - body.v[b], spring.dashpot);
    F[a] += f;
    F[b] -= f;
  });
  return F;
}

std::vector<double> eigenvalues_with_hub_held(int N)
{
  const RingObject object{.ring_points = N};
  const Eigen::MatrixXd K = stiffness_matrix(object.body().x, object.springs());
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

}  // namespace

class Modes : public testing::TestWithParam<int> {};

TEST_P(Modes, OfTheStiffnessMatrixAreTheAnalyticOnes)
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

TEST(Springs, TheStiffnessMatrixIsTheDerivativeOfTheForces)
{
  for (double lambda : {0.8, 1.0, 1.3}) {  // with springs that pull and that push
    const RingObject object{.ring_points = 7, .law = {.stiffness = 3.0}};
    PointBody body = object.body();
    stir(body, 0.02);
    for (int i = 0; i < body.size(); ++i) body.x[i] += body.v[i];
    const SpringSet springs = object.springs(lambda);
    const Eigen::MatrixXd K = stiffness_matrix(body.x, springs);
    for (int j = 0; j < 2 * body.size(); ++j) {
      const double h = 1e-6;
      auto forward = body.x, backward = body.x;
      forward[j / 2][j % 2] += h, backward[j / 2][j % 2] -= h;
      const auto plus = forces(forward, springs), minus = forces(backward, springs);
      for (int i = 0; i < 2 * body.size(); ++i) EXPECT_NEAR(K(i, j), (minus[i / 2][i % 2] - plus[i / 2][i % 2]) / (2.0 * h), 1e-8);
    }
  }
}

/// Velocity Verlet whose dashpots see the velocities of the half step before: does a small disturbance stay small?
bool stays_small(PointBody body, const SpringSet &springs, double dt)
{
  stir(body, 1e-6);
  for (int step = 0; step < 2000; ++step) {
    const std::vector<Vector2> F = forces(body.x, springs), D = dashpot_forces(body, springs);
    for (int i = 0; i < body.size(); ++i) body.v[i] += dt / body.mass[i] * (F[i] + D[i]), body.x[i] += dt * body.v[i];
    if (!(kinetic_energy(body) < 1.0)) return false;
  }
  return true;
}

TEST(Springs, TheStepLimitIsThatOfAnExplicitRun)
{
  for (int N : {3, 5, 20})
    for (bool spokes : {true, false})
      for (double e : {1.0, 0.3}) {
        const RingObject object{.ring_points = N, .spokes = spokes, .law = {.stiffness = 50.0, .damping = damping_ratio(e)}};
        const PointBody body = object.body();
        const SpringSet springs = object.springs();
        double dt = 1e-3;  // with dashpots the limit depends on the step itself
        for (int k = 0; k < 50; ++k) dt /= std::sqrt(step_over_limit(body.x, body.mass, springs, dt));
        EXPECT_NEAR(step_over_limit(body.x, body.mass, springs, dt), 1.0, 1e-6);
        EXPECT_TRUE(stays_small(body, springs, 0.99 * dt)) << N << " points, restitution " << e;
        EXPECT_FALSE(stays_small(body, springs, 1.02 * dt)) << N << " points, restitution " << e;
        const double bound = bound_of_step_over_limit(body.x, body.mass, springs, dt);
        EXPECT_GE(bound, 1.0 - 1e-6);
        EXPECT_LE(bound, 1.6);
      }
}

TEST(SpringLaw, AModulusGivesTheSameTensionAtTheSameStrain)
{
  const SpringLaw law{.modulus = 6.0};
  for (double length : {0.5, 2.0})
    for (double lambda : {1.0, 3.0}) {
      const Spring spring = law.scale(lambda, 1.0) * law.natural(length, 1.0, 1.0);
      EXPECT_DOUBLE_EQ(spring.length, lambda * length);
      EXPECT_DOUBLE_EQ(spring.stiffness * 0.1 * spring.length, 0.6);
    }
  const Spring slack = SpringLaw{.modulus = 6.0, .zero_lengths = true}.natural(0.5, 1.0, 1.0);
  EXPECT_EQ(slack.length, 0.0);
  EXPECT_DOUBLE_EQ(slack.stiffness, 12.0);
}

TEST(SpringLaw, StiffnessFollowsTheSwellingRatio)
{
  SpringLaw law{.stiffness = 10.0, .stiffening = {.power = -2.0}};
  EXPECT_DOUBLE_EQ(law.scale(2.0, 1.0).stiffness * law.natural(1.0, 1.0, 1.0).stiffness, 2.5);
  law.stiffening.table = {{1.0, 1.0}, {2.0, 0.4}, {4.0, 0.1}};
  EXPECT_DOUBLE_EQ(law.scale(0.5, 1.0).stiffness * law.natural(1.0, 1.0, 1.0).stiffness, 10.0) << "held before the table";
  EXPECT_DOUBLE_EQ(law.scale(1.5, 1.0).stiffness * law.natural(1.0, 1.0, 1.0).stiffness, 7.0);
  EXPECT_DOUBLE_EQ(law.scale(2.0, 1.0).stiffness * law.natural(1.0, 1.0, 1.0).stiffness, 4.0);
  EXPECT_DOUBLE_EQ(law.scale(9.0, 1.0).stiffness * law.natural(1.0, 1.0, 1.0).stiffness, 1.0) << "held beyond the table";
}

TEST(Springs, ForcesAreOppositeAndAlongTheSpring)
{
  const Vector2 A(0.3, -0.2), B(1.1, 0.4), U(0.7, 0.1), W(-0.2, 0.5), d = A - B;
  const Vector2 spring = spring_force({A, B}, 0.8, 3.0), dashpot = dashpot_force({A, B}, U - W, 0.7);
  EXPECT_EQ(spring, -spring_force({B, A}, 0.8, 3.0));
  EXPECT_EQ(dashpot, -dashpot_force({B, A}, W - U, 0.7));
  EXPECT_NEAR(spring.x() * d.y() - spring.y() * d.x(), 0.0, 1e-15);
  EXPECT_NEAR(dashpot.x() * d.y() - dashpot.y() * d.x(), 0.0, 1e-15);
}

TEST(Springs, PullBackAndPushApart)
{
  EXPECT_EQ(spring_force({{1.5, 0}, {0, 0}}, 1.0, 2.0), Vector2(-1.0, 0.0));
  EXPECT_EQ(spring_force({{0.5, 0}, {0, 0}}, 1.0, 2.0), Vector2(1.0, 0.0));
}

TEST(Springs, ADashpotOpposesTheClosingSpeedOnly)
{
  const Vector2 A(0, 0), B(1, 0);
  EXPECT_EQ(dashpot_force({A, B}, Vector2(-1, 0) - Vector2(1, 0), 1.5), Vector2(3, 0)) << "opening";
  EXPECT_EQ(dashpot_force({A, B}, Vector2(1, 0) - Vector2(-1, 0), 1.5), Vector2(-3, 0)) << "closing";
  EXPECT_EQ(dashpot_force({A, B}, Vector2(0, 1) - Vector2(0, -1), 1.5).norm(), 0.0) << "turning";
}

TEST(Springs, PointsOnOneSpotGiveNoForce)
{
  const Vector2 A(0.5, 0.5);
  EXPECT_EQ(spring_force({A, A}, 0.8, 3.0).norm(), 0.0);
  EXPECT_EQ(dashpot_force({A, A}, Vector2(1, 0) - Vector2(0, 1), 0.7).norm(), 0.0);
}

TEST(Springs, AllForcesOfAnObjectAreThoseOfItsSprings)
{
  SpringForces found;  // one for all, as a bed uses it
  for (int N : {21, 3, 8, 7, 20})
    for (bool spokes : {true, false}) {
      const RingObject object{.ring_points = N, .spokes = spokes, .law = {.stiffness = 50.0, .damping = 0.3}};
      PointBody body = object.body();
      stir(body, 0.1);
      for (int i = 0; i < body.size(); ++i) body.x[i] += body.v[i];
      body.x[1] = body.x[0];
      const SpringScale scale{.length = 1.2, .stiffness = 0.5, .dashpot = 0.7};
      const Vector2 none(1e3, 0.0);  // a hub without spokes: wherever it is
      std::vector<double> x, v;
      for (int k = 0; k <= N; ++k) {
        const Vector2 at = k < body.size() ? body.x[k] : none, velocity = k < body.size() ? body.v[k] : none;
        x.insert(x.end(), {at.x(), at.y(), 0.0});
        v.insert(v.end(), {velocity.x(), velocity.y(), 0.0});
      }
      std::vector<int> ring(N);
      std::iota(ring.begin(), ring.end(), 0);
      found.gather(ring.data(), N, N, x.data(), v.data());
      found.find(object.springs(), scale);
      SpringSet scaled = object.springs();
      for (auto *springs : {&scaled.ring, &scaled.spokes})
        for (int k = 0; k < springs->size(); ++k) springs->set(k, scale * (*springs)[k]);
      const std::vector<Vector2> F = forces(body.x, scaled), D = dashpot_forces(body, scaled);
      for (int k = 0; k <= N; ++k)
        for (int d = 0; d < 2; ++d) {
          EXPECT_NEAR(found.springs(d)[k], k < body.size() ? F[k][d] : 0.0, 1e-12) << N << " points, point " << k;
          EXPECT_NEAR(found.dashpots(d)[k], k < body.size() ? D[k][d] : 0.0, 1e-12) << N << " points, point " << k;
        }
    }
}

TEST(Springs, BondedPairKeepsTheAskedRestitution)
{
  for (double e : {0.1, 0.5, 0.9, 1.0}) {
    const double m_a = 2.0, m_b = 0.5, dt = 1e-5;
    const double k = 100.0, c = dashpot_constant(damping_ratio(e), k, m_a, m_b);
    Vector2 A(0, 0), B(1, 0), U(1, 0), W(-3, 0);
    do {  // until the spring is as long as at rest again
      const Vector2 F = spring_force({A, B}, 1.0, k) + dashpot_force({A, B}, U - W, c);
      U += dt / m_a * F, W -= dt / m_b * F;
      A += dt * U, B += dt * W;
    } while ((B - A).x() < 1.0);
    EXPECT_NEAR((W - U).x() / 4.0, e, 2e-4);
    EXPECT_NEAR(m_a * U.x() + m_b * W.x(), 2.0 - 1.5, 1e-9);
  }
}
