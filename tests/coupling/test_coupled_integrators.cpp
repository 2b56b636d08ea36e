// Objects in the fluid that are moved as a whole, at the fluid's own time step: stability, exchange of momentum, agreement with each other and on many ranks.
#include "coupled_scene.h"

using namespace swellflow_test;

namespace {

constexpr double lid = 0.1;

int fluid_steps() { return ranks() == 1 ? 1000 : 100; }  // several ranks are a matter of bookkeeping

struct Case {
  const char *integrator;
  double stiffness, density_ratio;
};

class WithoutSubSteps : public testing::TestWithParam<Case> {};

// At k_s = 1e10 the explicit limit is 30,000 times shorter.
TEST_P(WithoutSubSteps, ObjectsFollowTheFlow)
{
  const Case c = GetParam();
  CoupledScene scene;
  scene.integrator = c.integrator;
  scene.cavity(2, 0.2, c.density_ratio * 1000.0, c.stiffness, 50, 1, 5e-3);
  scene.script("run " + std::to_string(fluid_steps()) + "\n");
  EXPECT_LT(scene.fastest_point(), lid);
  EXPECT_GT(scene.fastest_point(), 1e-4 * lid);
  EXPECT_LT(scene.water(1), 0.01 * lid) << "mean slip";
  EXPECT_LT(scene.water(3), 1e-10) << "divergence";
  EXPECT_LT(scene.water(8), 1e-12) << "momentum";
}

INSTANTIATE_TEST_SUITE_P(Integrators, WithoutSubSteps,
                         testing::Values(Case{"nve/cds implicit", 1e2, 1.05}, Case{"nve/cds implicit", 1e3, 1.5}, Case{"nve/cds implicit", 1e6, 1.05},
                                         Case{"nve/cds implicit", 1e10, 3.0}, Case{"nve/cds implicit energy conserve", 1e3, 1.5},
                                         Case{"rigid/cds", 1e3, 1.05}, Case{"rigid/cds", 1e3, 3.0}));

DryScene::State moved_by(const std::string &integrator, double stiffness, int every)
{
  CoupledScene scene;
  scene.integrator = integrator;
  scene.cavity(2, 0.2, 1500.0, stiffness, 50, every, 5e-3);
  scene.script("run " + std::to_string(fluid_steps() * every) + "\n");
  return scene.state();
}

double farthest(const DryScene::State &a, const DryScene::State &b)
{
  double largest = 0.0;
  for (const auto &[tag, p] : a) largest = std::max(largest, std::hypot(p[0] - b.at(tag)[0], p[1] - b.at(tag)[1]));
  return largest;
}

TEST(Integrators, AgreeWhereTheyMust)
{
  CoupledScene still;
  still.cavity(2, 0.2, 1500.0, 1e3, 50, 10, 5e-3);
  const DryScene::State start = still.state(), rigid = moved_by("rigid/cds", 1e3, 1), stiff = moved_by("nve/cds implicit", 1e8, 1),
                        soft = moved_by("nve/cds implicit", 1e3, 1), sub_stepped = moved_by("nve/cds", 1e3, 20);
  const double way = farthest(rigid, start);
  EXPECT_GT(way, 1e-7 * fluid_steps() * fluid_steps());
  EXPECT_LT(farthest(stiff, rigid), 2e-3 * way);
  EXPECT_LT(farthest(soft, sub_stepped), 1e-2 * way);
}

TEST(Integrators, DoTheSameOnManyRanks)
{
  for (const char *integrator : {"nve/cds implicit", "rigid/cds"}) {
    CoupledScene parallel, alone(MPI_COMM_SELF);
    for (CoupledScene *scene : {&parallel, &alone}) {
      scene->integrator = integrator;
      scene->cavity(3, 0.19, 1500.0, 1000.0, 64, 1, 5e-3, scene == &parallel ? "* 1 1" : "* * 1");
      scene->script("fix grow all swell linear rate 0.04 max 0.3\nrun 150\n");
    }
    EXPECT_LT(largest_difference(parallel.state(), alone.state()), 1e-9) << integrator;
  }
}

}  // namespace
