// A rigid body that may swell: how it turns, grows and feels drag.
#include <gtest/gtest.h>

#include "liggghts_plugins/objects/rigid_motion.h"
#include "ring_object.h"

using namespace swellflow;
using namespace swellflow_test;

TEST(RigidMotion, TurnsFallsAndKeepsItsShape)
{
  const RingObject object;
  PointBody body = object.body();
  spin_up(body, 3.0);
  for (Vector2 &v : body.v) v += Vector2(1.0, 2.0);
  for (int step = 0; step < 1000; ++step) move_rigidly(body, object.body().x, 1e-3);
  for (int i = 0; i < body.size(); ++i) {
    const Vector2 r = rotated(std::cos(3.0), std::sin(3.0), object.body().x[i]);
    EXPECT_LT((body.x[i] - Vector2(1.0, 2.0) - r).norm(), 1e-12);
    EXPECT_LT((body.v[i] - Vector2(1.0, 2.0) - turned(3.0, r)).norm(), 1e-11);
  }
}

TEST(RigidMotion, SlowsItsSpinAsItGrows)
{
  const RingObject object;
  PointBody body = object.body();
  spin_up(body, 3.0);
  const double before = whole_motion(body).angular_momentum;
  for (int step = 1; step <= 1000; ++step) {
    std::vector<Vector2> rest = object.body().x;
    for (Vector2 &x : rest) x *= 1.0 + 1e-3 * step;
    move_rigidly(body, rest, 1e-3);
  }
  EXPECT_NEAR(whole_motion(body).angular_momentum, before, 1e-10 * before);
  EXPECT_NEAR(whole_motion(body).spin(), 3.0 / 4.0, 1e-9) << "moment of inertia times four";
  for (int k = 0; k < 20; ++k) EXPECT_NEAR((body.v[k] - body.v[20]).dot(body.x[k] - body.x[20]) / (body.x[k] - body.x[20]).norm(), 0.5, 1e-9);
}

TEST(RigidMotion, ReachesTheSpeedOfTheStreamAndBooksWhatItReceived)
{
  const RingObject object;
  for (double kappa : {0.5, 1e8}) {
    PointBody body = object.body(true);
    spin_up(body, 2.0);
    const Vector2 before = momentum(body);
    const double angular_before = whole_motion(body).angular_momentum;
    double angular = 0.0;
    Vector2 received = Vector2::Zero();
    for (int step = 0; step < 400; ++step) {
      const WholeMotion whole = whole_motion(body);
      std::vector<Vector2> arm;
      for (int i = 0; i < body.size(); ++i) {
        arm.push_back(body.x[i] - whole.centre);
        body.impulse[i].setZero();
        if (i < 20) body.kappa[i] = kappa, body.a[i] = kappa * (Vector2(1.0, 0.0) + turned(-0.5, arm[i]));
      }
      move_rigidly(body, object.body().x, 0.01);
      for (int i = 0; i < body.size(); ++i) received += body.impulse[i], angular += cross(arm[i], body.impulse[i]);
    }
    EXPECT_LT((momentum(body) - before - received).norm(), 1e-11);
    EXPECT_NEAR(whole_motion(body).angular_momentum, angular_before + angular, 1e-11);
    EXPECT_NEAR(whole_motion(body).velocity.x(), 1.0, 1e-6);
    EXPECT_NEAR(whole_motion(body).spin(), -0.5, 1e-6);
  }
}
