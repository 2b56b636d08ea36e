// Implicit steps of springs: momentum, energy, the rigid limit, order, modes, restitution, drag, and what is left when the step is hard.
#include <gtest/gtest.h>

#include <Eigen/Dense>

#include "liggghts_plugins/objects/implicit_springs.h"
#include "liggghts_plugins/objects/rigid_motion.h"
#include "liggghts_plugins/objects/vibrations.h"
#include "ring_object.h"

using namespace swellflow;
using namespace swellflow_test;
using std::numbers::pi;

namespace {

void run(PointBody &body, const SpringSet &springs, SpringEnergy energy, double dt, int steps)
{
  ImplicitSprings solver(energy);
  const std::vector<Vector2> none(body.size(), Vector2::Zero());
  for (int step = 0; step < steps; ++step) ASSERT_TRUE(solver.advance(body, springs, none, dt)) << "step " << step;
}

double largest_distance(const PointBody &a, const PointBody &b)
{
  double largest = 0.0;
  for (int i = 0; i < a.size(); ++i) largest = std::max(largest, (a.x[i] - b.x[i]).norm());
  return largest;
}

/// Motion to compare with: velocity Verlet in very small steps.
void run_finely(PointBody &body, const SpringSet &springs, double dt, int steps)
{
  std::vector<Vector2> f(body.size());
  const auto forces = [&] {
    f.assign(body.size(), Vector2::Zero());
    for_each_spring(springs, [&](int a, int b, const Spring &s) {
      const Direction along(body.x[a], body.x[b]);
      const Vector2 F = spring_force(along, s.length, s.stiffness) + dashpot_force(along, body.v[a] - body.v[b], s.dashpot);
      f[a] += F;
      f[b] -= F;
    });
  };
  forces();
  for (int step = 0; step < steps; ++step) {
    for (int i = 0; i < body.size(); ++i) body.v[i] += 0.5 * dt / body.mass[i] * f[i], body.x[i] += dt * body.v[i];
    forces();
    for (int i = 0; i < body.size(); ++i) body.v[i] += 0.5 * dt / body.mass[i] * f[i];
  }
}

}  // namespace

class Energies : public testing::TestWithParam<SpringEnergy> {};

TEST_P(Energies, KeepMomentumAtAnyStep)
{
  for (double k : {1.0, 1e4, 1e10})
    for (bool spokes : {true, false}) {
      const RingObject object{.spokes = spokes, .law = {.stiffness = k, .damping = damping_ratio(0.8)}};
      PointBody body = object.body();
      spin_up(body, 3.0);
      stir(body, 0.2);
      const WholeMotion before = whole_motion(body);
      run(body, object.springs(), GetParam(), 0.02, 50);
      const WholeMotion after = whole_motion(body);
      EXPECT_LT((after.velocity - before.velocity).norm(), 1e-13);
      EXPECT_NEAR(after.angular_momentum, before.angular_momentum, 1e-12 * before.angular_momentum);
      EXPECT_LT((after.centre - before.centre - 50 * 0.02 * before.velocity).norm(), 1e-12);
    }
}

TEST_P(Energies, TendToTheRigidBodyAsSpringsStiffen)
{
  double error = 1.0;
  for (double k : {1e4, 1e6, 1e8, 1e12}) {
    const RingObject object{.law = {.stiffness = k}};
    PointBody body = object.body(), rigid = body;
    spin_up(body, 4.0);
    for (Vector2 &v : body.v) v += Vector2(0.3, -0.1);
    rigid = body;
    run(body, object.springs(), GetParam(), 0.01, 300);  // two turns, 0.04 rad a step
    for (int step = 0; step < 300; ++step) move_rigidly(rigid, object.body().x, 0.01);
    const double now = largest_distance(body, rigid);
    EXPECT_LT(now, std::max(0.02 * error, 2e-6)) << "stiffness " << k;
    error = now;
  }
}

TEST_P(Energies, FollowTheTrueMotionOfASoftBody)
{
  const RingObject object{.law = {.stiffness = 40.0}};
  PointBody exact = object.body();
  spin_up(exact, 1.0);
  for (int k = 0; k < 20; ++k) exact.v[k] += 0.3 * std::cos(4.0 * pi * k / 20) * exact.x[k];  // two waves round the ring
  const PointBody start = exact;
  run_finely(exact, object.springs(), 5e-5, 10000);
  const int expected_order = GetParam() == SpringEnergy::conserve ? 2 : 1;
  double error = 0.0;
  for (double dt : {0.001, 0.0005, 0.00025}) {
    PointBody body = start;
    run(body, object.springs(), GetParam(), dt, std::lround(0.5 / dt));
    const double now = largest_distance(body, exact);
    if (error > 0.0) {
      EXPECT_NEAR(std::log2(error / now), expected_order, 0.15) << "step " << dt;
    }
    error = now;
  }
}

TEST_P(Energies, HaveTheAnalyticModes)
{
  // omega^2 m / k of mode n for a held hub, which stays by itself but for n = 1: [T -+ sqrt(T^2 - 16 cos^2 a sin^2 n a)]/2, T = 1 + 4 (sin^2 a cos^2 n a + cos^2 a sin^2 n a).
  for (int n : {0, 2, 5, 10}) {
    const double a = pi / 20, q = std::pow(std::sin(a) * std::cos(n * a), 2) + std::pow(std::cos(a) * std::sin(n * a), 2), T = 1.0 + 4.0 * q;
    const double ratio = 0.5 * (T + std::sqrt(std::max(0.0, T * T - 16.0 * std::pow(std::cos(a) * std::sin(n * a), 2))));
    const RingObject object{.law = {.stiffness = 100.0}};
    const double omega = std::sqrt(ratio * 100.0 / object.ring_mass());
    // The shape of the mode, from the stiffness matrix.
    PointBody body = object.body();
    const Eigen::MatrixXd K = stiffness_matrix(body.x, object.springs());
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(K.topLeftCorner(40, 40));
    int nearest = 0;
    for (int j = 0; j < 40; ++j)
      if (std::abs(solver.eigenvalues()[j] - ratio * 100.0) < std::abs(solver.eigenvalues()[nearest] - ratio * 100.0)) nearest = j;
    for (int i = 0; i < 20; ++i) body.v[i] = 1e-4 * omega * solver.eigenvectors().col(nearest).segment<2>(2 * i);
    // Half a period later the same shape swings back: the work of both is of opposite sign, and zero a quarter before.
    const PointBody start = body;
    const double dt = 2.0 * pi / omega / 400.0;
    ImplicitSprings integrator(GetParam());
    const std::vector<Vector2> none(21, Vector2::Zero());
    double before = 1.0, crossing = 0.0;
    for (int step = 1; crossing == 0.0 && step < 300; ++step) {
      ASSERT_TRUE(integrator.advance(body, object.springs(), none, dt));
      double now = 0.0;
      for (int i = 0; i < 20; ++i) now += (body.x[i] - start.x[i]).dot(start.v[i]);
      if (now < 0.0) crossing = step - now / (now - before);
      before = now;
    }
    EXPECT_NEAR(crossing, 200.0, 1.0) << "half a period of mode " << n << " in steps: within 0.5 %";
  }
}

TEST_P(Energies, GiveTheAskedRestitutionToABondedPair)
{
  // Two points of a ring of three without spokes would feel the third: so the third is far heavier, and at rest.
  const double dt = 2e-4, e = 0.6;
  PointBody body;
  body.resize(3, false);
  body.x = {Vector2(0.0, 0.0), Vector2(1.0, 0.0), Vector2(0.5, 2.0)};
  body.v = {Vector2(1.0, 0.0), Vector2(-3.0, 0.0), Vector2(0.0, 0.0)};
  body.mass = {2.0, 0.5, 1e9};
  body.force.assign(3, Vector2::Zero());
  SpringSet springs;
  springs.ring.assign(3, Spring{.length = std::hypot(0.5, 2.0), .stiffness = 1e-9});
  springs.ring.set(0, {.length = 1.0, .stiffness = 100.0, .dashpot = dashpot_constant(damping_ratio(e), 100.0, 2.0, 0.5)});
  ImplicitSprings solver(GetParam());
  const std::vector<Vector2> none(3, Vector2::Zero());
  do ASSERT_TRUE(solver.advance(body, springs, none, dt));
  while ((body.x[1] - body.x[0]).norm() < 1.0);
  EXPECT_NEAR((body.v[1] - body.v[0]).x() / 4.0, e, 0.01 * e);
}

TEST_P(Energies, CopeWithObjectsThatAreCrushedOrTurnedInsideOut)
{
  for (double k : {1.0, 1e6})
    for (double size : {0.1, -0.8}) {
      const RingObject object{.law = {.stiffness = k}};
      PointBody body = object.body();
      for (int i = 0; i < 20; ++i) body.x[i].x() *= size;
      run(body, object.springs(), GetParam(), 0.01, 30);
      for (int i = 0; i < body.size(); ++i) EXPECT_TRUE(std::isfinite(body.x[i].sum() + body.v[i].sum()));
    }
}

TEST_P(Energies, TakeStiffDragsWithoutHarmAndBookWhatTheyGive)
{
  for (double kappa : {1.0, 1e6}) {
    const RingObject object{.law = {.stiffness = 1e4}};
    PointBody body = object.body(true);
    spin_up(body, 2.0);
    for (int i = 0; i < 20; ++i) body.kappa[i] = kappa, body.a[i] = kappa * Vector2(0.5, 0.0);
    const Vector2 before = momentum(body);
    run(body, object.springs(), GetParam(), 0.01, 1000);
    Vector2 received = Vector2::Zero();
    for (const Vector2 &impulse : body.impulse) received += impulse;
    EXPECT_LT((momentum(body) - before - received).norm(), 1e-11);
    Vector2 ring = Vector2::Zero();  // a hub within a ring that is held fast may swing for long
    double spin = 0.0;
    for (int i = 0; i < 20; ++i) ring += body.v[i] / 20.0, spin += cross(body.x[i] - body.x[20], body.v[i]) / (20.0 * 0.25);
    EXPECT_LT((ring - Vector2(0.5, 0.0)).norm(), 1e-3) << "the body moves with the stream";
    EXPECT_NEAR(spin, 0.0, 1e-3);
  }
}

INSTANTIATE_TEST_SUITE_P(ImplicitSprings, Energies, testing::Values(SpringEnergy::dissipate, SpringEnergy::conserve),
                         [](const auto &info) { return info.param == SpringEnergy::conserve ? "conserve" : "dissipate"; });

TEST(ImplicitSprings, ConserveKeepsTheEnergyAtAnyStep)
{
  for (double dt : {1e-3, 0.03, 0.3}) {  // omega dt up to 30
    const RingObject object{.law = {.stiffness = 100.0}};
    PointBody body = object.body();
    spin_up(body, 2.0);
    stir(body, 0.5);
    const SpringSet springs = object.springs();
    const double before = kinetic_energy(body) + spring_energy(body, springs);
    run(body, springs, SpringEnergy::conserve, dt, 300);
    EXPECT_NEAR((kinetic_energy(body) + spring_energy(body, springs)) / before, 1.0, 1e-9) << "step " << dt;
  }
}

TEST(ImplicitSprings, DissipateNeverGainsEnergyAndEndsAsARigidBody)
{
  for (double dt : {1e-3, 0.03, 0.3}) {
    const RingObject object{.law = {.stiffness = 100.0}};
    PointBody body = object.body();
    spin_up(body, 0.5);
    stir(body, 0.5);
    const SpringSet springs = object.springs();
    ImplicitSprings solver(SpringEnergy::dissipate);
    const std::vector<Vector2> none(body.size(), Vector2::Zero());
    double energy = kinetic_energy(body) + spring_energy(body, springs);
    for (int step = 0; step < 1000; ++step) {
      ASSERT_TRUE(solver.advance(body, springs, none, dt));
      const double now = kinetic_energy(body) + spring_energy(body, springs);
      ASSERT_LE(now, energy * (1.0 + 1e-12)) << "step " << step << " of " << dt;
      energy = now;
    }
    const WholeMotion whole = whole_motion(body);
    const double rigid = 0.5 * whole.mass * whole.velocity.squaredNorm() + 0.5 * whole.angular_momentum * whole.spin();
    if (dt > 0.01) {
      EXPECT_NEAR(energy / rigid, 1.0, 0.02);
    }
  }
}

TEST(ImplicitSprings, AGrowingObjectFollowsItsNaturalLengthsWithoutTurning)
{
  const RingObject object{.law = {.stiffness = 1e6}};
  PointBody body = object.body();
  ImplicitSprings solver(SpringEnergy::dissipate);
  const std::vector<Vector2> none(body.size(), Vector2::Zero());
  for (int step = 1; step <= 2000; ++step) ASSERT_TRUE(solver.advance(body, object.springs(1.0 + 2e-3 * step), none, 5e-3));
  for (int k = 0; k < 20; ++k) {
    EXPECT_NEAR((body.x[k] - body.x[20]).norm(), 0.5 * 5.0, 1e-6);
    EXPECT_NEAR(cross(object.body().x[k], body.x[k] - body.x[20]) / (0.5 * 2.5), 0.0, 1e-10);
  }
}
