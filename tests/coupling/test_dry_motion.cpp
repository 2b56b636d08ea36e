// The explicit integrator: plain velocity Verlet, and the fluid's drag law taken implicitly with the impulse that it gave.
#include "dry_scene.h"

#include "fix_property_atom.h"
#include "liggghts_plugins/fluid_columns.h"

using namespace swellflow_test;
using swellflow::FluidImpulse;
using swellflow::FluidLaw;

namespace {

constexpr double dt = 1e-3;

/// One object whose points have the drag law force = A - kappa v, in place of a fluid.
class DragScene : public DryScene {
public:
  explicit DragScene(double kappa)
  {
    box("0 1 0 1");
    script("create_objects disk 0.5 0.5 diameter 0.2 points 10 density 1000 cds 0.1\n"
           "fix fluid_law all property/atom fluid_law vector yes no no 0 0 0 0\n"
           "fix fluid_impulse all property/atom fluid_impulse vector yes no no 0 0 0\n"
           "fix fluid_ahead all property/atom fluid_ahead vector yes no no 0 0 0 0 0\n"
           "fix move all nve/cds\ntimestep 1e-3\nrun 0\n");
    for (int i = 0; i < atom()->nlocal; i++) {
      double *law = property("fluid_law")[i];
      law[FluidLaw::KAPPA] = kappa, law[FluidLaw::A_X] = 2.0, law[FluidLaw::A_Y] = -1.0;
    }
  }
  double **property(const char *name) const { return static_cast<LAMMPS_NS::FixPropertyAtom *>(fix(name))->array_atom; }
};

}  // namespace

TEST(DryMotion, TheImpulseIsExactlyTheMomentumGained)
{
  for (double kappa : {0.0, 1.0, 1e3, 1e9}) {
    DragScene scene(kappa);
    scene.script("run 50\n");
    for (int i = 0; i < scene.atom()->nlocal; i++)
      for (int d = 0; d < 2; d++) {
        const double gained = scene.atom()->rmass[i] * scene.atom()->v[i][d];
        EXPECT_NEAR(scene.property("fluid_impulse")[i][d], gained, 1e-12 * std::max(1e-3, std::abs(gained))) << "kappa = " << kappa;
      }
  }
}

TEST(DryMotion, AnyDragIsStableAndEndsAtTheFluidsVelocity)
{
  for (double kappa : {1e2, 1e5, 1e12}) {
    DragScene scene(kappa);
    scene.change([](int, double *, double *v) { v[0] = 0.5, v[1] = 0.3; });
    scene.script("run 400\n");
    for (int i = 0; i < scene.atom()->nlocal; i++) {
      if (kappa * dt < scene.atom()->rmass[i]) continue;  // still on its way
      EXPECT_NEAR(scene.atom()->v[i][0], 2.0 / kappa, 1e-9);
      EXPECT_NEAR(scene.atom()->v[i][1], -1.0 / kappa, 1e-9);
    }
  }
}

TEST(DryMotion, WithoutAFluidItIsVelocityVerlet)
{
  const auto end_of = [](const std::string &integrator) {
    DryScene scene;
    scene.box("0 1 0 1");
    scene.script("create_objects disk 0.5 0.5 diameter 0.2 points 10 density 1000 cds 0.1\nfix springs all mass_spring stiffness 1000\n"
                 "fix weight all gravity 9.81 vector 0 -1 0\nfix move all " + integrator + "\ntimestep 1e-4\n");
    scene.change([](int tag, double *, double *v) { v[0] = 0.1 * std::sin(1.0 * tag); });
    scene.script("run 300\n");
    return scene.state();
  };
  EXPECT_LT(largest_difference(end_of("nve/cds"), end_of("nve")), 1e-14);
}

TEST(DryMotion, HeldPointsStay)
{
  DryScene scene;
  scene.box("0 1 0 1");
  scene.script("create_objects disk 0.5 0.5 diameter 0.2 points 10 density 1000 cds 0.1\n"
               "create_objects disk 0.2 0.2 diameter 0.2 points 10 density 1000 cds 0.1\ngroup free molecule 2\n"
               "fix springs all mass_spring stiffness 1000\nfix weight all gravity 9.81 vector 0 -1 0\nfix move free nve/cds\n"
               "timestep 1e-4\nrun 100\n");
  const auto state = scene.state();
  EXPECT_EQ(state.at(1)[1], 0.5);
  EXPECT_NEAR(state.at(12)[1], 0.2 - 0.5 * 9.81 * 1e-4, 1e-7);
}

TEST(DryMotion, ALawThatWasTakenOutIsNotFelt)
{
  DryScene scene;
  scene.box("0 1 0 1");
  scene.script("create_atoms 1 single 0.5 0.5 0 units box\nset group all diameter 0.1 density 1000\nfix move all nve/cds\n"
               "fix fluid_law all property/atom fluid_law vector yes no no 0 1 0 0\n"
               "fix fluid_impulse all property/atom fluid_impulse vector yes no no 0 0 0\n"
           "fix fluid_ahead all property/atom fluid_ahead vector yes no no 0 0 0 0 0\ntimestep 1e-3\nrun 10\n");
  const double gained = scene.state().at(1)[2];
  EXPECT_GT(gained, 0.0);
  scene.script("unfix fluid_impulse\nunfix fluid_ahead\nunfix fluid_law\nrun 10 pre no\nrun 10\n");
  EXPECT_EQ(scene.state().at(1)[2], gained);
}
