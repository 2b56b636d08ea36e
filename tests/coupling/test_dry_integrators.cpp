// Objects moved as a whole, implicitly or rigidly, inside LIGGGHTS: on any number of ranks, over restarts, against rigid mechanics, off walls and along floors.
#include <cstdio>
#include <numbers>

#include "dry_scene.h"

using namespace swellflow_test;
using std::numbers::pi;

namespace {

constexpr const char *implicit = "nve/cds implicit", *conserving = "nve/cds implicit energy conserve", *rigid = "rigid/cds";

class Integrators : public testing::TestWithParam<const char *> {};

std::string wall_at(double y)
{
  const std::string place = std::to_string(y);
  return "fix wall_" + place.substr(0, 1) + place.substr(2, 2) + " all wall/gran model hooke/stiffness tangential history primitive type 1 yplane " + place + " absolute_damping on\n";
}

/// Nine discs that swell, collide with each other and with walls, fall, and cross the sides of a box that is periodic along x.
void crowd(DryScene &scene, const std::string &integrator)
{
  scene.box("0 1 0 1", "p f p");
  scene.script("fix m1 all property/global kn peratomtypepair 1 2e5\n");
  scene.script("create_objects lattice 3 3 origin 0.2 0.2 spacing 0.3 0.28 disk diameter 0.16 points 12 density 1500 cds 0.1\n");
  scene.script("fix springs all mass_spring stiffness 3e5 restitution 0.8\nfix grow all swell linear rate 0.05 max 0.2\nfix move all " + integrator +
               "\nfix flat all enforce2d\nfix weight all gravity 2.0 vector 0 -1 0\n" + wall_at(0.02) + wall_at(0.98) + "timestep 1e-3\n");
  scene.change([](int tag, double *x, double *v) { v[0] = 0.5 + 0.2 * std::sin(1.0 * ((tag - 1) / 13)), v[1] = 0.2 * std::cos(5.0 * x[0]); });
}

struct Whole {
  double x = 0.0, y = 0.0, vx = 0.0, vy = 0.0, mass = 0.0, spin = 0.0, inertia = 0.0;
};

/// Centre of mass and motion of an object of n points with the tags from `first` on.
Whole whole(const DryScene::State &state, int first, int n)
{
  Whole sum;
  for (int tag = first; tag < first + n; tag++) {
    const auto &p = state.at(tag);
    sum.mass += p[5], sum.x += p[5] * p[0], sum.y += p[5] * p[1], sum.vx += p[5] * p[2], sum.vy += p[5] * p[3];
  }
  for (double *value : {&sum.x, &sum.y, &sum.vx, &sum.vy}) *value /= sum.mass;
  for (int tag = first; tag < first + n; tag++) {
    const auto &p = state.at(tag);
    const double rx = p[0] - sum.x, ry = p[1] - sum.y;
    sum.spin += p[5] * (rx * p[3] - ry * p[2]);
    sum.inertia += p[5] * (rx * rx + ry * ry);
  }
  sum.spin /= sum.inertia;
  return sum;
}

}  // namespace

TEST_P(Integrators, DoOnManyRanksWhatTheyDoOnOne)
{
  DryScene together, alone(MPI_COMM_SELF);
  for (DryScene *scene : {&together, &alone}) {
    crowd(*scene, GetParam());
    scene->script("run 500\n");
  }
  EXPECT_LT(largest_difference(together.state(), alone.state()), 1e-8);
  double farthest = 0.0;
  for (const auto &[tag, p] : alone.state()) farthest = std::max(farthest, p[0]);
  EXPECT_GT(farthest, 1.05) << "some must have crossed the periodic side";
}

TEST_P(Integrators, GoOnFromARestartFileAndInParts)
{
  const std::string file = "integrators_" + std::to_string(ranks()) + ".restart";
  DryScene whole_run, first, second;
  crowd(whole_run, GetParam());
  whole_run.script("run 300\n");
  crowd(first, GetParam());
  first.script("run 100\nrun 50 pre no\nwrite_restart " + file + "\n");
  second.script("atom_modify map array\nread_restart " + file + "\nnewton off\ncommunicate single vel yes\nsoft_particles yes\n");
  second.settings();
  second.script("fix m1 all property/global kn peratomtypepair 1 2e5\n");
  second.script("fix springs all mass_spring stiffness 3e5 restitution 0.8\nfix grow all swell linear rate 0.05 max 0.2\nfix move all " +
                std::string(GetParam()) + "\nfix flat all enforce2d\nfix weight all gravity 2.0 vector 0 -1 0\n" + wall_at(0.02) + wall_at(0.98) + "timestep 1e-3\nrun 150\n");
  EXPECT_LT(largest_difference(second.state(), whole_run.state()), 1e-12);
  MPI_Barrier(MPI_COMM_WORLD);
  if (rank() == 0) std::remove(file.c_str());
}

TEST_P(Integrators, FallAndSpinAsARigidBodyFarAboveTheExplicitLimit)
{
  DryScene scene;
  scene.box("-3 3 -20 3");
  scene.script("create_objects disk 0 0 diameter 0.2 points 20 density 1500\nfix springs all mass_spring stiffness 1e10\nfix move all " + std::string(GetParam()) +
               "\nfix weight all gravity 9.81 vector 0 -1 0\ntimestep 2e-3\n");
  scene.change([](int, double *x, double *v) { v[0] = 1.0 - 6.0 * x[1], v[1] = 2.0 + 6.0 * x[0]; });
  scene.script("run 500\n");
  const auto state = scene.state();
  const Whole disc = whole(state, 1, 21);
  EXPECT_NEAR(disc.x, 1.0, 1e-9);
  EXPECT_NEAR(disc.y, 2.0 - 0.5 * 9.81, 1e-9);
  EXPECT_NEAR(disc.vy, 2.0 - 9.81, 1e-9);
  EXPECT_NEAR(disc.spin, 6.0, 6e-3);
  const double angle = std::atan2(state.at(2)[1] - state.at(1)[1], state.at(2)[0] - state.at(1)[0]);
  EXPECT_NEAR(std::remainder(angle - 6.0, 2.0 * pi), 0.0, 6e-3) << "0.1 % of one radian a second six times";
  for (int k = 2; k <= 21; k++) EXPECT_NEAR(std::hypot(state.at(k)[0] - disc.x, state.at(k)[1] - disc.y), 0.1, 1e-4);
}

TEST_P(Integrators, BounceOffAWallAtTheSpeedTheyCame)
{
  for (double damping : {0.0, 1500.0}) {
    DryScene scene;
    scene.box("0 1 0 1");
    scene.script("fix m1 all property/global kn peratomtypepair 1 1e6\nfix m3 all property/global gamman_abs peratomtypepair 1 " + std::to_string(damping) + "\n");
    scene.script("create_objects disk 0.5 0.5 diameter 0.2 points 20 density 1000 cds 0.1\nfix springs all mass_spring stiffness 1e9\nfix move all " +
                 std::string(GetParam()) + "\n" + wall_at(0.2) + "timestep 5e-5\n");
    scene.change([](int, double *, double *v) { v[1] = -1.0; });
    scene.script("run 12000\n");
    const Whole disc = whole(scene.state(), 1, 21);
    // One sphere meets the wall, the whole mass hangs on it: e = exp(-zeta pi / sqrt(1 - zeta^2)), zeta = gamma / (2 sqrt(M k_n)).
    const double zeta = damping / (2.0 * std::sqrt(disc.mass * 1e6));
    EXPECT_NEAR(disc.vy, std::exp(-zeta * pi / std::sqrt(1.0 - zeta * zeta)), damping == 0.0 ? 2e-3 : 2e-2) << "damping " << damping;
    EXPECT_NEAR(disc.vx, 0.0, 1e-9);
  }
}

TEST_P(Integrators, RollAsTheirSpheresDo)
{
  for (const std::string spin : {"frozen", "body"}) {
    DryScene scene;
    scene.box("0 40 0 1", "f f p", "0.02", "-0.5 0.5");
    scene.script("fix m2 all property/global kt peratomtypepair 1 5e4\nfix m5 all property/global coefficientFriction peratomtypepair 1 0.3\n");
    const int n = 100;
    scene.script("create_objects disk 0.5 0.3995 diameter 0.3 points 100 density 1000 cds 0.1667\nfix springs all mass_spring stiffness 1e9\nfix move all " +
                 std::string(GetParam()) + " spin " + spin + "\nfix weight all gravity 5 vector 0 -1 0\n" + wall_at(0.2) + "timestep 2e-4\n");
    scene.change([](int, double *, double *v) { v[0] = 2.0; });
    scene.script("run 2500\n");
    const Whole disc = whole(scene.state(), 1, n + 1);
    // Friction keeps the angular momentum about the floor. What is in contact lies at the edge of the spheres, or, when they do not turn, at their centres.
    const double arm = spin == "body" ? 0.15 + 0.1667 * 0.3 : 0.15, rolling = 2.0 / (1.0 + disc.inertia / (disc.mass * arm * arm));
    EXPECT_NEAR(disc.vx, rolling, 0.04 * rolling) << spin;
    EXPECT_NEAR(-disc.spin * arm, disc.vx, 0.04 * rolling) << spin;
  }
}

INSTANTIATE_TEST_SUITE_P(Dry, Integrators, testing::Values(implicit, conserving, rigid), [](const auto &info) {
  return std::string(info.param == implicit ? "implicit" : info.param == rigid ? "rigid" : "conserving");
});

TEST(ExplicitSteps, AreStableRightBelowTheirLimit)
{
  DryScene scene;
  scene.box("0 1 0 1");
  scene.script("create_objects disk 0.5 0.5 diameter 0.2 points 20 density 1000 cds 0.1\nfix springs all mass_spring stiffness 1000\nfix move all nve/cds\ntimestep 1e-4\nrun 0\n");
  char line[100];
  std::snprintf(line, sizeof line, "timestep %.9g\n", 0.99 * 1e-4 / scene.fix("springs")->compute_vector(3));
  scene.script(line);
  scene.change([](int tag, double *, double *v) { v[0] = 1e-6 * std::sin(7.0 * tag); });
  scene.script("run 3000\n");
  for (const auto &[tag, p] : scene.state()) EXPECT_LT(std::hypot(p[2], p[3]), 1e-4);
  EXPECT_NEAR(scene.fix("springs")->compute_vector(3), 0.99, 1e-3);
}
