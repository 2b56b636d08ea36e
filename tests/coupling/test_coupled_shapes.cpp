// What the fluid knows of an object's shape: its outline, wherever the mass points lie, and whether there are spokes.
#include "coupled_scene.h"

using namespace swellflow_test;

namespace {

/// One held object in the middle of a periodic box of 48 x 48 cells through which fluid is driven to the right.
class HeldObject : public CoupledScene {
public:
  explicit HeldObject(const std::string &object, const std::string &fluid = "")
  {
    script("units si\ndimension 2\natom_style hybrid granular molecular\natom_modify map array\nboundary p p p\nnewton off\ncommunicate single vel yes\n"
           "region box block 0 1 0 1 -0.5 0.5 units box\ncreate_box 1 box\ncreate_objects " + object + " density 1\nfix body all held\n"
           "fix water all fluid/ib cells 48 48 density 1 viscosity 1 mean_velocity x 1 mean_velocity y 0 advection none " + fluid + "\n"
           "timestep 1e-3\nrun 40\n");
  }
  double drag() { return fix("body")->compute_vector(0); }
  double lift() { return fix("body")->compute_vector(1); }
};

const std::string disc = "disk 0.5 0.5 diameter 0.35 cds 0.1 points ";

}  // namespace

// With 20 points a ring point has three markers, with 54 it has one.
TEST(CoupledShapes, TheFluidMeetsTheOutlineWhereverTheMassPointsAre)
{
  for (const std::string points : {"20", "54"}) {
    HeldObject on(disc + points), inside(disc + points + " reach 0"), far_inside(disc + points + " reach 0 mass equal cds_points 1 hub_cds no");
    EXPECT_GT(on.drag(), 1.0);
    EXPECT_NEAR(inside.drag(), on.drag(), 1e-9 * on.drag());
    EXPECT_NEAR(far_inside.drag(), on.drag(), 1e-9 * on.drag());
    EXPECT_NEAR(inside.water(9), on.water(9), 1e-12) << "distance of markers";
    EXPECT_LE(on.water(9), 1.0);
    EXPECT_LT(inside.water(8), 1e-12);
  }
}

TEST(CoupledShapes, OfAnEllipseTheOutlineIsMetWithPointsInside)
{
  const std::string ellipse = "ellipse 0.5 0.5 axes 0.5 0.25 angle 25 points 40 cds 0.08";
  HeldObject on(ellipse), inside(ellipse + " reach 0.01");
  EXPECT_GT(on.drag(), 1.0);
  EXPECT_GT(std::abs(on.lift()), 0.05 * on.drag()) << "it stands at an angle";
  EXPECT_NEAR(inside.drag(), on.drag(), 1e-9 * on.drag());
  EXPECT_NEAR(inside.lift(), on.lift(), 1e-9 * on.drag());
}

TEST(CoupledShapes, MarkersAreCloseEnoughWherePointsAreFarApart)
{
  HeldObject ellipse("ellipse 0.5 0.5 axes 0.48 0.12 points 24 point_spacing angle cds 0.05");
  EXPECT_LE(ellipse.water(9), 1.0);
  EXPECT_GT(ellipse.water(9), 0.5);
}

TEST(CoupledShapes, MembranesHaveTheirMarkersOnTheOutline)
{
  HeldObject membrane(disc + "54 spokes no"), plain(disc + "54", "retraction 0"), retracted(disc + "54");
  EXPECT_NEAR(membrane.drag(), plain.drag(), 1e-9 * plain.drag());
  EXPECT_GT(membrane.drag(), retracted.drag() * 1.01);
  EXPECT_LT(membrane.water(8), 1e-12);
}

// A membrane, an ellipse and a disc with its points inside, free in a lid-driven cavity.
TEST(CoupledShapes, FreeOnesKeepTheBalanceOfMomentumOnAnyNumberOfRanks)
{
  const auto run = [](CoupledScene &scene) {
    scene.box("0 1 0 1");
    scene.script("create_objects disk 0.3 0.7 diameter 0.3 points 32 density 1500 cds 0.05 spokes no\n"
                 "create_objects ellipse 0.7 0.7 axes 0.35 0.2 angle 40 points 32 density 1500 cds 0.05\n"
                 "create_objects disk 0.5 0.3 diameter 0.3 points 32 density 1500 cds 0.08 reach 0.01\n"
                 "fix springs all mass_spring stiffness 1000\nfix move all nve/cds\nfix flat all enforce2d\n"
                 "fix water all fluid/ib cells 32 32 density 1000 viscosity 0.01 every 4 wall yhi velocity 0.5 0\ntimestep 1e-3\nrun 800\n");
    EXPECT_LT(scene.water(8), 1e-12);
    EXPECT_GT(scene.fastest_point(), 0.01);
    return scene.state();
  };
  CoupledScene together, alone(MPI_COMM_SELF);
  const auto state = run(together);
  EXPECT_LT(largest_difference(state, run(alone)), 1e-9);
  double mean[2] = {0.0, 0.0};
  for (int k = 2; k <= 33; k++)
    for (int d = 0; d < 2; d++) mean[d] += state.at(k)[d] / 32;
  EXPECT_NEAR(std::hypot(state.at(1)[0] - mean[0], state.at(1)[1] - mean[1]), 0.0, 1e-12);
  EXPECT_GT(std::abs(mean[0] - 0.3) + std::abs(mean[1] - 0.7), 1e-3) << "the membrane has moved";
}

TEST(CoupledShapes, SwellWithTheirPointsInsideInAClosedBox)
{
  CoupledScene scene;
  scene.box("0 1 0 1");
  scene.script("create_objects ellipse 0.5 0.5 axes 0.36 0.25 points 60 density 1500 cds 0.05 reach 0.01\n"
               "fix springs all mass_spring stiffness 1e4\nfix move all nve/cds\nfix flat all enforce2d\n"
               "fix water all fluid/ib cells 50 50 density 1000 viscosity 0.01 every 10\nfix grow all swell linear rate 0.02 max 0.5\ntimestep 2e-4\nrun 10000\n");
  const double natural = 0.3 + 0.02 * 2.0;
  double area = 0.0;
  EXPECT_NEAR(scene.fix("grow")->compute_vector(0), natural, 1e-12);
  const auto state = scene.state();
  for (int k = 2; k <= 61; k++) {
    const auto &p = state.at(k), &q = state.at(k < 61 ? k + 1 : 2);
    area += 0.5 * (p[0] * q[1] - q[0] * p[1]);
  }
  // The ring encloses less than the outline, by the same share as when it was made.
  EXPECT_NEAR(scene.fix("grow")->compute_vector(2), natural, 0.001 * natural);
  EXPECT_LT(area, 0.25 * 3.14159 * natural * natural * 0.85);
  EXPECT_LT(scene.water(8), 1e-12);
}
