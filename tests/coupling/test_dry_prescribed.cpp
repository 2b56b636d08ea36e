// Objects that are held, or move as a script tells: where they are, how fast, and what they say the fluid does to them.
#include "fake_fluid.h"

#include <numbers>

using namespace swellflow_test;

namespace {

/// Three objects of 11 points each: one in the middle, on the border of all ranks; one across the corners of a periodic box; one elsewhere.
const std::string three_objects = "create_objects disk 0.5 0.5 diameter 0.2 points 10 density 1000 cds 0.1\n"
                                  "create_objects disk 0.97 0.96 diameter 0.2 points 10 density 1000 cds 0.1\n"
                                  "create_objects disk 0.25 0.6 diameter 0.1 points 10 density 1000 cds 0.1\n"
                                  "fix springs all mass_spring stiffness 1000\nfix weight all gravity 9.81 vector 0 -1 0\n";

void make_periodic_scene(DryScene &scene, const std::string &fixes)
{
  scene.box("0 1 0 1", "p p p");
  scene.script(three_objects + fixes + "run 0\n");
}

int hub_of(int tag) { return (tag - 1) / 11 * 11 + 1; }

/// Where the first hub is after a time of 1 with the velocity 0.3 cos 5 t along x, less where it should be.
double error_of_variable_motion(int steps)
{
  DryScene scene;
  scene.script("variable u equal 0.3*cos(5*time)\nvariable w equal 2*cos(5*time)\n");
  make_periodic_scene(scene, "fix move all prescribed velocity v_u 0 spin v_w\n");
  scene.script("timestep " + std::to_string(1.0 / steps) + "\nrun " + std::to_string(steps) + "\n");
  const auto state = scene.state();
  const double hub = state.at(1)[0] - 0.5 - 0.06 * std::sin(5.0);
  const double angle = std::atan2(state.at(2)[1] - state.at(1)[1], state.at(2)[0] - state.at(1)[0]) - 0.4 * std::sin(5.0);
  EXPECT_NEAR(angle / 0.4, hub / 0.06, 1e-9);
  return hub;
}

}  // namespace

TEST(DryPrescribed, HeldPointsKeepTheirLastBit)
{
  DryScene scene;
  make_periodic_scene(scene, "fix move all held\n");
  scene.change([](int tag, double *x, double *v) { x[0] += 1e-3 * std::sin(7.0 * tag), v[0] = 0.1, v[1] = 1.0 / tag; });  // stretched springs
  const auto before = scene.state();
  scene.script("timestep 1e-3\nrun 500\n");
  for (const auto &[tag, now] : scene.state()) {
    EXPECT_EQ(now[0], before.at(tag)[0]);
    EXPECT_EQ(now[1], before.at(tag)[1]);
    EXPECT_EQ(now[2], 0.0);
    EXPECT_EQ(now[3], 0.0);
  }
}

TEST(DryPrescribed, ConstantVelocityIsExact)
{
  DryScene scene;
  make_periodic_scene(scene, "fix move all prescribed velocity 0.4 -0.3\n");
  const auto before = scene.state();
  scene.script("timestep 1e-2\nrun 700\n");  // round the periodic box and on
  for (const auto &[tag, now] : scene.state()) {
    EXPECT_NEAR(now[0], before.at(tag)[0] + 2.8, 1e-12);
    EXPECT_NEAR(now[1], before.at(tag)[1] - 2.1, 1e-12);
    EXPECT_EQ(now[2], 0.4);
    EXPECT_EQ(now[3], -0.3);
  }
}

TEST(DryPrescribed, VariableVelocityIsOfSecondOrder)
{
  const double coarse = error_of_variable_motion(50), fine = error_of_variable_motion(100);
  EXPECT_GT(std::abs(coarse), 1e-6);
  EXPECT_GT(coarse / fine, 3.9);
  EXPECT_LT(coarse / fine, 4.1);
}

TEST(DryPrescribed, RotationKeepsTheRadius)
{
  constexpr double spin = 3.0, dt = 1e-3;
  constexpr int steps = 5000;
  DryScene scene;
  make_periodic_scene(scene, "fix move all prescribed velocity 0.05 0.1 spin 3\n");
  const auto before = scene.state();
  scene.script("timestep 1e-3\nrun 5000\n");
  const auto after = scene.state();
  for (const auto &[tag, now] : after) {
    const auto &hub = after.at(hub_of(tag)), &old = before.at(tag), &old_hub = before.at(hub_of(tag));
    const double rx = now[0] - hub[0], ry = now[1] - hub[1], old_rx = old[0] - old_hub[0], old_ry = old[1] - old_hub[1];
    const double angle = spin * dt * steps;
    EXPECT_NEAR(std::hypot(rx, ry), std::hypot(old_rx, old_ry), 1e-13);
    EXPECT_NEAR(rx, std::cos(angle) * old_rx - std::sin(angle) * old_ry, 1e-12);
    EXPECT_NEAR(ry, std::sin(angle) * old_rx + std::cos(angle) * old_ry, 1e-12);
    EXPECT_NEAR(now[2], 0.05 - spin * ry, 1e-14);
    EXPECT_NEAR(now[3], 0.1 + spin * rx, 1e-14);
  }
}

TEST(DryPrescribed, OtherObjectsBounceOffAndStayFree)
{
  DryScene scene;
  scene.box("0 1 0 1");
  scene.script("create_objects disk 0.5 0.3 diameter 0.2 points 16 density 1000 cds 0.2\ncreate_objects disk 0.5 0.6 diameter 0.2 points 16 density 1000 cds 0.2\n"
               "group low molecule 1\ngroup high molecule 2\nfix springs all mass_spring stiffness 1e4\nfix weight all gravity 9.81 vector 0 -1 0\n"
               "fix stay low held\nfix move high nve/cds\ntimestep 1e-4\nrun 0\n");
  const auto before = scene.state();
  scene.script("run 2000\n");
  const auto after = scene.state();
  for (int tag = 1; tag <= 17; tag++) EXPECT_EQ(after.at(tag), before.at(tag));
  EXPECT_GT(after.at(18)[1], 0.5);  // without the other it would have fallen by 0.2
  EXPECT_LT(after.at(18)[1], 0.6);
}

TEST(DryPrescribed, WithoutAFluidThereIsNoForce)
{
  FakeFluidScene scene;
  make_periodic_scene(scene, "fix move all prescribed velocity 0.4 -0.3 spin 2\n");
  scene.script("timestep 1e-3\nrun 10\n");
  const double expected[] = {0.0, 0.0, 0.0, 0.4, -0.3, 2.0};
  for (int n = 1; n <= 6; n++) EXPECT_EQ(scene.value("move", n), expected[n - 1]);
}

// ---- with a law in place of a fluid ----------------------------------------------------------------------------------------------------------

namespace {

constexpr double kappa = 2.0, ax = 3.0, ay = -1.0, rho_f = 1000.0, dt = 1e-3;
constexpr int points = 33;

class LawScene : public FakeFluidScene {
public:
  explicit LawScene(const std::string &fixes, int every = 4)
  {
    talk.kappa = kappa, talk.ax = ax, talk.ay = ay, talk.dem_steps = {every};
    make_periodic_scene(*this, "fix water all fluid/ib cells 20 20 density 1000 viscosity 0.01 every 4\n" + fixes + "timestep 1e-3\n");
  }
};

/// Of the three discs together: sum of V, sum of V R^2 / 2, sum of r^2 over the ring points.
constexpr double pi = std::numbers::pi;
constexpr double area = pi * (0.01 + 0.01 + 0.0025), inertia = 0.5 * pi * (1e-4 + 1e-4 + 6.25e-6), ring_squares = 10.0 * (0.01 + 0.01 + 0.0025);

}  // namespace

TEST(DryPrescribed, TheImpulseIsThatOfTheLawAtTheGivenVelocity)
{
  LawScene scene("fix move all prescribed velocity 0.4 -0.3\n");
  scene.script("run 12\n");
  double received = scene.talk.received.back();
  MPI_Allreduce(MPI_IN_PLACE, &received, 1, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
  EXPECT_NEAR(received, points * 4 * dt * (ax - kappa * 0.4), 1e-12);
  EXPECT_NEAR(scene.value("move", 1), points * (ax - kappa * 0.4), 1e-9);
  EXPECT_NEAR(scene.value("move", 2), points * (ay + kappa * 0.3), 1e-9);
  EXPECT_NEAR(scene.value("move", 3), 0.0, 1e-9);
}

TEST(DryPrescribed, TheTorqueIsAboutEachHub)
{
  LawScene scene("fix move all prescribed spin 2\n");
  scene.script("run 200\n");
  EXPECT_NEAR(scene.value("move", 1), points * ax, 1e-9);
  EXPECT_NEAR(scene.value("move", 3), -kappa * 2.0 * ring_squares, 1e-9);
}

TEST(DryPrescribed, TheInertiaOfTheFluidInsideIsCountedOut)
{
  LawScene scene("variable u equal 5*time\nvariable w equal 7*time\nfix move all prescribed velocity v_u 0 spin v_w\n");
  scene.script("run 8\n");
  const double middle = 6 * dt;  // of the second fluid step
  EXPECT_NEAR(scene.value("move", 1), points * (ax - kappa * 5.0 * middle) + rho_f * area * 5.0, 1e-8);
  EXPECT_NEAR(scene.value("move", 2), points * ay, 1e-8);
  EXPECT_NEAR(scene.value("move", 3), -kappa * 7.0 * middle * ring_squares + rho_f * inertia * 7.0, 1e-8);
  EXPECT_NEAR(scene.value("move", 4), 5.0 * 8 * dt, 1e-15);
  EXPECT_NEAR(scene.value("move", 6), 7.0 * 8 * dt, 1e-15);
}

TEST(DryPrescribed, ValuesAreThoseOfTheLastWholeFluidStep)
{
  LawScene scene("variable u equal 5*time\nfix move all prescribed velocity v_u 0\n");
  scene.script("run 3\n");
  EXPECT_EQ(scene.value("move", 1), 0.0);  // none is whole yet
  scene.script("run 1\n");
  const double first = scene.value("move", 1);
  EXPECT_NEAR(first, points * (ax - kappa * 5.0 * 2 * dt) + rho_f * area * 5.0, 1e-8);
  for (int n = 0; n < 3; n++) {
    scene.script(n == 1 ? "run 1 pre no\n" : "run 1\n");
    EXPECT_EQ(scene.value("move", 1), first);
  }
  scene.script("run 1\n");
  EXPECT_NEAR(scene.value("move", 1), first - points * kappa * 5.0 * 4 * dt, 1e-8);
  scene.script("unfix water\nrun 1\n");
  EXPECT_EQ(scene.value("move", 1), 0.0);
}

TEST(DryPrescribed, HeldObjectsInAFluidFeelItAtRest)
{
  LawScene scene("group some molecule 1 3\ngroup rest molecule 2\nfix stay some held\nfix move rest nve/cds\n");
  scene.script("run 9\n");
  EXPECT_NEAR(scene.value("stay", 1), 22 * ax, 1e-10);
  EXPECT_NEAR(scene.value("stay", 2), 22 * ay, 1e-10);
  EXPECT_EQ(scene.value("stay", 4), 0.0);
}
