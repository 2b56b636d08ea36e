// Lubrication between discs and at walls, without a fluid: what the formula says, momentum, and steps of any length.
#include "dry_scene.h"

#include <numbers>

#include "liggghts_plugins/objects/lubrication.h"

using namespace swellflow_test;
using std::numbers::pi;

namespace {

constexpr int POINTS = 17;  // of an object
const std::string lubrication = "fix gaps all lubrication/cds viscosity 1 cutoff 0.02 pair_cutoff 0.018 minimum 1e-4\n";
const swellflow::LubricationLaw law{.viscosity = 1.0, .wall_cutoff = 0.02, .pair_cutoff = 0.018, .minimum = 1e-4};
const double R = 0.1;

std::string disc(double x, double y, double density = 1000.0)
{
  return "create_objects disk " + std::to_string(x) + " " + std::to_string(y) + " diameter 0.2 points 16 cds 0.05 reach 0 density " + std::to_string(density) + "\n";
}

struct Body {
  double mass = 0.0, x = 0.0, y = 0.0, vx = 0.0, vy = 0.0, largest_vx = -1e300, smallest_vx = 1e300;
};

/// By number, in the order in which they were made.
std::vector<Body> bodies(const DryScene &scene)
{
  std::vector<Body> all;
  for (const auto &[tag, p] : scene.state()) {
    all.resize(std::max<std::size_t>(all.size(), (tag - 1) / POINTS + 1));
    Body &body = all[(tag - 1) / POINTS];
    body.mass += p[5];
    body.x += p[5] * p[0], body.y += p[5] * p[1];
    body.vx += p[5] * p[2], body.vy += p[5] * p[3];
    body.largest_vx = std::max(body.largest_vx, p[2]);
    body.smallest_vx = std::min(body.smallest_vx, p[2]);
  }
  for (Body &body : all) body.x /= body.mass, body.y /= body.mass, body.vx /= body.mass, body.vy /= body.mass;
  return all;
}

/// Each object gets the velocity velocity(number), then the run.
template <typename Velocity>
void run(DryScene &scene, double dt, int steps, const Velocity &velocity)
{
  scene.change([&](int tag, double *, double *v) {
    const std::array<double, 2> u = velocity((tag - 1) / POINTS);
    v[0] = u[0], v[1] = u[1];
  });
  char line[80];
  std::snprintf(line, sizeof line, "timestep %.17g\nrun %d\n", dt, steps);
  scene.script(line);
}

std::array<double, 2> together(int n) { return {n == 0 ? 0.1 : -0.1, 0.0}; }

double value(const DryScene &scene, int n) { return scene.fix("gaps")->compute_vector(n); }

}  // namespace

TEST(DryLubrication, TwoDiscsLoseTheirSpeedAsTheFormulaSays)
{
  // mu dV/dt = -c(gap) V, dgap/dt = -V: mu V falls by the integral of c over the gap, here C(g) = -2 a g^-0.5 with c = a g^-1.5 - c_cutoff.
  DryScene scene;
  scene.box("0 1 0 1");
  const double gap = 0.015, offset = R + 0.5 * gap;
  scene.script(disc(0.5 - offset, 0.5) + disc(0.5 + offset, 0.5) + "fix move all rigid/cds\n" + lubrication);
  run(scene, 1e-5, 5000, together);
  const auto now = bodies(scene);
  const double reduced = now[0].mass / 2.0, left = now[1].x - now[0].x - 2.0 * R, c_cutoff = swellflow::lubrication_resistance(1.0, 0.5 * R, 0.018);
  const double a = swellflow::lubrication_resistance(1.0, 0.5 * R, 1.0);
  const double impulse = 2.0 * a * (1.0 / std::sqrt(left) - 1.0 / std::sqrt(gap)) - c_cutoff * (gap - left);
  ASSERT_LT(left, 0.8 * gap);
  EXPECT_NEAR((now[0].vx - now[1].vx) / (0.2 - impulse / reduced), 1.0, 1e-4);
  EXPECT_LT(now[0].vx - now[1].vx, 0.19);
  EXPECT_NEAR(value(scene, 1), left, 2e-5);
  EXPECT_EQ(value(scene, 0), 1.0);
}

TEST(DryLubrication, ForcesAreThoseOfTheFormulaAndOpposite)
{
  // Moved as told they feel all of it, however long the step.
  for (const std::string motion : {"rigid/cds", "prescribed velocity 0 0"}) {
    DryScene scene;
    scene.box("0 1 0 1");
    scene.script(disc(0.395, 0.5) + "group left id > 0\n" + disc(0.605, 0.5, 3000.0) + "group right subtract all left\n" + lubrication);
    if (motion == "rigid/cds") scene.script("fix move all rigid/cds\n");
    else scene.script("fix a left prescribed velocity 0.1 0\nfix b right prescribed velocity -0.1 0\n");
    run(scene, motion == "rigid/cds" ? 1e-12 : 1.0, 0, together);
    double F[2][2] = {{0.0, 0.0}, {0.0, 0.0}};
    for (const auto &[tag, f] : scene.forces())
      for (int d = 0; d < 2; d++) F[(tag - 1) / POINTS][d] += f[d];
    const double expected = 0.2 * law.missing_between(R, R, 0.01);
    EXPECT_NEAR(F[1][0] / expected, 1.0, 1e-9) << motion;
    EXPECT_NEAR(F[0][0] + F[1][0], 0.0, 1e-13 * expected);
    EXPECT_NEAR(F[0][1], 0.0, 1e-13 * expected);
    EXPECT_NEAR(value(scene, 1), 0.01, 1e-14);
    EXPECT_NEAR(value(scene, 2) / (0.2 * expected), 1.0, 1e-9);
  }
}

TEST(DryLubrication, MomentumIsKeptToRoundOff)
{
  for (const std::string boundary : {"f f p", "p p p"}) {
    DryScene scene;
    scene.box("0 1 0 1", boundary);
    // Three on the borders of all ranks; with periodic sides two across them. Nothing but lubrication acts on their points.
    scene.script(disc(0.395, 0.5) + disc(0.605, 0.5, 3000.0) + disc(0.5, 0.69) +
                 (boundary == "p p p" ? disc(0.02, 0.1) + disc(0.815, 0.05) : "") + "fix move all nve/cds\n" + lubrication);
    const auto velocity = [](int n) -> std::array<double, 2> { return {0.1 * std::cos(2.0 * n), n == 2 ? -0.2 : 0.1 * std::sin(n)}; };
    run(scene, 1e-4, 0, velocity);
    double before[2] = {0.0, 0.0}, after[2] = {0.0, 0.0}, scale = 0.0;
    for (const Body &body : bodies(scene)) before[0] += body.mass * body.vx, before[1] += body.mass * body.vy, scale += body.mass * 0.1;
    EXPECT_EQ(value(scene, 0), boundary == "p p p" ? 4.0 : 3.0);
    const double first = bodies(scene)[2].vy;
    scene.script("run 200\n");
    for (const Body &body : bodies(scene)) after[0] += body.mass * body.vx, after[1] += body.mass * body.vy;
    EXPECT_GT(bodies(scene)[2].vy, first + 1e-3);  // something happened
    for (int d = 0; d < 2; d++) EXPECT_NEAR(after[d] / scale, before[d] / scale, 1e-13) << boundary << ", " << d;
  }
}

TEST(DryLubrication, RanksAgree)
{
  const auto make = [](MPI_Comm comm) {
    DryScene scene(comm);
    scene.box("0 1 0 1", "p p p");
    scene.script(disc(0.395, 0.5) + disc(0.605, 0.5, 3000.0) + disc(0.5, 0.69) + disc(0.02, 0.1) + disc(0.815, 0.05) + "fix move all nve/cds\n" + lubrication);
    run(scene, 1e-4, 500, [](int n) -> std::array<double, 2> { return {0.1 * std::cos(2.0 * n), n == 2 ? -0.2 : 0.1 * std::sin(n)}; });
    return scene.state();
  };
  EXPECT_LT(largest_difference(make(MPI_COMM_WORLD), make(MPI_COMM_SELF)), 1e-12);
}

TEST(DryLubrication, AStepMayBeAThousandTimesTheExplicitLimit)
{
  // A light disc with six heavy ones around it, at gaps of the minimum: pair by pair a step of Euler backward would throw it back twice as fast as it came.
  DryScene scene;
  scene.box("0 1 0 1");
  const double pitch = 2.0 * R + 1e-4;
  std::string script = disc(0.5, 0.5, 10.0);
  for (int k = 0; k < 6; k++) script += disc(0.5 + pitch * std::cos(k * pi / 3.0), 0.5 + pitch * std::sin(k * pi / 3.0));
  scene.script(script + "fix move all rigid/cds\n" + lubrication);
  const double limit = 2.0 * bodies(scene)[0].mass / law.missing_between(R, R, 1e-4);
  const auto velocity = [](int n) -> std::array<double, 2> { return {1e-7 * std::cos(3.0 * n), 1e-7 * std::sin(5.0 * n)}; };
  const auto energy = [&] {
    double sum = 0.0;
    for (const Body &body : bodies(scene)) sum += 0.5 * body.mass * (body.vx * body.vx + body.vy * body.vy);
    return sum;
  };
  run(scene, 1e3 * limit, 0, velocity);
  const double start = energy();
  double before = start;
  for (int k = 0; k < 20; k++) {
    scene.script("run 5\n");
    EXPECT_LE(energy(), (1.0 + 1e-12) * before);
    before = energy();
  }
  EXPECT_LT(before, 0.9 * start);  // sliding, and motion in common, stay
}

TEST(DryLubrication, AWallStopsADiscWithoutDeformingIt)
{
  for (const std::string motion : {"fix move all rigid/cds\n", "fix springs all mass_spring stiffness 1e5\nfix move all nve/cds implicit\n",
                                   "fix springs all mass_spring stiffness 1e5\nfix move all nve/cds\n"}) {
    DryScene scene;
    scene.box("0 1 0 1");
    scene.script(disc(0.11, 0.5) + motion + lubrication);
    run(scene, 1e-4, 1000, [](int) -> std::array<double, 2> { return {-0.02, 0.0}; });
    const Body now = bodies(scene)[0];
    const double gap = 0.01, left = now.x - R, a = swellflow::lubrication_resistance(1.0, R, 1.0), c_cutoff = swellflow::lubrication_resistance(1.0, R, 0.02);
    const double impulse = 2.0 * a * (1.0 / std::sqrt(left) - 1.0 / std::sqrt(gap)) - c_cutoff * (gap - left);
    EXPECT_NEAR(now.vx / (-0.02 + impulse / now.mass), 1.0, 2e-3) << motion;
    EXPECT_GT(now.vx, -0.018);
    EXPECT_LT(now.largest_vx - now.smallest_vx, 1e-9) << motion;
  }
}
