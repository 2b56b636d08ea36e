// Shear and spin: a flow that starts linear, objects that start with it or with a spin of their own, and the angular momentum that fluid and objects exchange.
#include "coupled_scene.h"
#include "liggghts_plugins/fix_fluid_ib.h"
#include "liggghts_plugins/fluid_columns.h"
#include "liggghts_plugins/objects/point_body.h"

#include "fix_property_atom.h"

using namespace swellflow_test;
using swellflow::FluidHome;
using swellflow::FluidImpulse;

namespace {

/// For a fluid alone.
void empty_box(CoupledScene &scene, const std::string &region, const std::string &boundary)
{
  scene.script("units si\ndimension 2\natom_style hybrid granular molecular\natom_modify map array\nboundary " + boundary + "\nnewton off\ncommunicate single vel yes\n"
               "region box block " + region + " -0.5 0.5 units box\ncreate_box 1 box\n");
}

struct Cell {
  double x, y, u, v, pressure;
};

/// visit(cell) for those of this rank.
template <class Visit> void for_each_cell(const CoupledScene &scene, const Visit &visit)
{
  const swellflow::FluidPartner &fluid = *LAMMPS_NS::find_fluid(scene.lmp())->partner();
  const swellflow::FieldBlock block = fluid.field_block();
  std::vector<double> velocity, pressure;
  fluid.copy_field("velocity", velocity);
  fluid.copy_field("pressure", pressure);
  const auto place = [&](int d, int n) { return block.origin[d] + (block.first[d] + n + 0.5) * block.spacing; };
  for (int j = 0; j < block.count[1]; j++)
    for (int i = 0; i < block.count[0]; i++) {
      const int n = j * block.count[0] + i;
      visit(Cell{place(0, i), place(1, j), velocity[3 * n], velocity[3 * n + 1], pressure[n]});
    }
}

double sum_over_ranks(const CoupledScene &scene, double here)
{
  MPI_Allreduce(MPI_IN_PLACE, &here, 1, MPI_DOUBLE, MPI_SUM, scene.lmp()->world);
  return here;
}

/// Motion of all points of a scene with one object.
swellflow::WholeMotion motion(const DryScene &scene)
{
  swellflow::PointBody body;
  for (const auto &[tag, p] : scene.state()) {
    body.x.emplace_back(p[0], p[1]);
    body.v.emplace_back(p[2], p[3]);
    body.mass.push_back(p[5]);
  }
  return whole_motion(body);
}

}  // namespace

// ---- a flow that starts linear ---------------------------------------------------------------------------------------------------------------

/// It is the steady flow between the walls, also on cells: nothing of it may change.
TEST(LinearStart, IsTheFlowThatTheWallsKeepUp)
{
  for (const bool along_x : {true, false}) {
    CoupledScene scene;
    scene.script("variable u equal 1-0*time\n");
    empty_box(scene, along_x ? "-1 1 0.5 1.5" : "0.5 1.5 -1 1", along_x ? "p f p" : "f p p");
    scene.script(std::string("fix water all fluid/ib density 1000 viscosity 0.01 initial_velocity linear cells ") +
                 (along_x ? "32 16 wall ylo velocity -0.5 0 wall yhi velocity v_u 0" : "16 32 wall xlo velocity 0 -0.5 wall xhi velocity 0 v_u") + "\ntimestep 0.02\n");
    for (const char *run : {"run 0\n", "run 20\n"}) {
      scene.script(run);
      for_each_cell(scene, [&](const Cell &cell) {
        EXPECT_NEAR(along_x ? cell.u : cell.v, -0.5 + 1.5 * ((along_x ? cell.y : cell.x) - 0.5), 1e-13);
        EXPECT_NEAR(along_x ? cell.v : cell.u, 0.0, 1e-13);
      });
    }
  }
}

/// The walls across that rest let nothing through.
TEST(LinearStart, MayLieInAClosedBox)
{
  CoupledScene scene;
  empty_box(scene, "0 1 0 1", "f f p");
  scene.script("fix water all fluid/ib density 1000 viscosity 0.01 cells 16 16 wall yhi velocity 1 0 initial_velocity linear\ntimestep 0.02\nrun 1\n");
  EXPECT_LT(scene.water(3), 1e-12) << "divergence";
  EXPECT_GT(scene.water(5), 0.05 * 1000.0 / 6);  // of the energy of the linear flow
  EXPECT_LT(scene.water(5), 0.95 * 1000.0 / 6);
}

// ---- objects that move from the start --------------------------------------------------------------------------------------------------------

class FromTheStart : public testing::TestWithParam<const char *> {};

TEST_P(FromTheStart, AsVelocityCommandsSay)
{
  DryScene scene;
  scene.box("0 1 0 1");
  scene.script("create_objects disk 0.5 0.5 diameter 0.2 points 16 density 1000\nfix springs all mass_spring stiffness 1e8\nfix move all " + std::string(GetParam()) + "\n");
  scene.script("velocity all set 0.3 -0.1 0\nvariable vx atom -2*(y-0.5)\nvariable vy atom 2*(x-0.5)\nvelocity all set v_vx v_vy NULL sum yes\ntimestep 1e-3\nrun 100\n");
  const swellflow::WholeMotion whole = motion(scene);
  EXPECT_NEAR(whole.velocity.x(), 0.3, 1e-12);
  EXPECT_NEAR(whole.velocity.y(), -0.1, 1e-12);
  EXPECT_NEAR(whole.spin(), 2.0, 1e-6);  // springs stretch a little
  EXPECT_NEAR(whole.centre.x(), 0.5 + 0.1 * 0.3, 1e-12);
}

/// A ramp over the points of an object is its mean velocity, half of the shear as spin, and a stretching that the object does not follow.
TEST_P(FromTheStart, WithTheShearedFluid)
{
  const auto slip_after_a_step = [](const std::string &start) {
    CoupledScene scene;
    scene.box("0 2 0 1", "p f p");
    scene.script("create_objects disk 1 0.3 diameter 0.25 points 26 density 1100\nfix springs all mass_spring stiffness 1e5\nfix move all " + std::string(GetParam()) + "\n" + start +
                 "fix water all fluid/ib cells 64 32 density 1000 viscosity 0.01 wall ylo velocity -0.5 0 wall yhi velocity 0.5 0 initial_velocity linear\n"
                 "timestep 0.01\nrun 1\n");
    const swellflow::WholeMotion whole = motion(scene);
    if (!start.empty()) {
      EXPECT_NEAR(whole.velocity.x(), -0.2, 2e-4);
      EXPECT_NEAR(whole.velocity.y(), 0.0, 2e-4);
      EXPECT_NEAR(whole.spin(), -0.5, 5e-3);
    }
    return std::hypot(scene.water(6), scene.water(7));
  };
  const double force_on_what_rests = slip_after_a_step("");
  EXPECT_LT(slip_after_a_step("velocity all ramp vx -0.5 0.5 y 0 1\n"), 0.05 * force_on_what_rests);
}

INSTANTIATE_TEST_SUITE_P(Integrators, FromTheStart, testing::Values("rigid/cds", "nve/cds implicit"));

// ---- angular momentum ------------------------------------------------------------------------------------------------------------------------

/// A disc that turns in the middle of a box of fluid, for so short a time that no shear reaches the walls. The pressure does: the grid gives it four lobes.
class Turning : public CoupledScene {
public:
  Turning(const std::string &motion, const std::string &fluid)
  {
    box("-1 1 -1 1");
    script("create_objects disk 0 0 diameter 0.5 points 32 density 1500\nfix springs all mass_spring stiffness 1e6\nfix move all " + motion +
           "\nvariable vx atom -2*y\nvariable vy atom 2*x\nvelocity all set v_vx v_vy NULL\n"
           "fix water all fluid/ib cells 64 64 density 1000 viscosity 0.01 advection none " + fluid + "\ntimestep 0.01\nrun 0\n");
  }

  void steps(int n)
  {
    for (int s = 0; s < n; s++) {
      const State before = state();  // where the fluid knows the points to be
      script("run 1\n");
      double received = 0.0;
      for (int i = 0; i < atom()->nlocal; i++) {
        const auto &point = before.at(atom()->tag[i]);
        received += point[0] * from_fluid(i, 1) - point[1] * from_fluid(i, 0);
      }
      last_received_ = sum_over_ranks(*this, received);
      received_ += last_received_;
      given_by_walls_ += fluid_step * sum_over_ranks(*this, torque_of_walls());
    }
  }
  /// What the object has received, and in the last step.
  double received() const { return received_; }
  double last_received() const { return last_received_; }
  /// What nobody has.
  double missing() const
  {
    double of_fluid = 0.0;
    for_each_cell(*this, [&](const Cell &cell) { of_fluid += 1000.0 * h * h * (cell.x * cell.v - cell.y * cell.u); });
    return sum_over_ranks(*this, of_fluid) + received_ - given_by_walls_;
  }

private:
  static constexpr double h = 2.0 / 64, fluid_step = 0.01;

  double **property(const char *name) const { return static_cast<LAMMPS_NS::FixPropertyAtom *>(fix(name))->array_atom; }

  /// The impulse that the fluid gave to a point; the rest of what it received is the inertia of the fluid inside.
  double from_fluid(int i, int d) const
  {
    return property(FluidImpulse::NAME)[i][FluidImpulse::RECEIVED_X + d] - fluid_step * property(FluidHome::NAME)[i][FluidHome::INNER_FORCE_X + d];
  }

  double torque_of_walls() const
  {
    double torque = 0.0;
    for_each_cell(*this, [&](const Cell &cell) {
      if (std::abs(cell.y) > 1.0 - h) torque -= std::copysign(h, cell.y) * cell.x * cell.pressure;
      if (std::abs(cell.x) > 1.0 - h) torque += std::copysign(h, cell.x) * cell.y * cell.pressure;
    });
    return torque;
  }

  double received_ = 0.0, last_received_ = 0.0, given_by_walls_ = 0.0;
};

class AngularMomentum : public testing::TestWithParam<const char *> {};

/// Interpolation, spreading and the flow keep the arm of a force. What is left is the shear of the little flow that the pressure drives along the walls.
TEST_P(AngularMomentum, IsExchangedWhereMarkersArePoints)
{
  Turning scene(GetParam(), "retraction 0 marker_gap 2");
  scene.steps(40);
  EXPECT_LT(scene.received(), -1.0);
  EXPECT_NEAR(scene.missing(), 0.0, 1e-5 * std::abs(scene.received()));
}

/// The change of a marker's force acts on its point in the step in which it is made, and on all that the marker hangs on from the next one on. So a share of the angular momentum
/// of a step, on an arm of the retraction, is under way; it does not add up.
TEST_P(AngularMomentum, LagsByAStepOnTheWayFromMarkersToPoints)
{
  Turning scene(GetParam(), "");
  const double retraction_over_radius = 0.3 * (2.0 / 64) / 0.25;
  scene.steps(1);
  const double most = std::abs(scene.last_received());
  for (int round = 0; round < 6; round++) {
    scene.steps(20);
    EXPECT_LT(std::abs(scene.last_received()), most);
    EXPECT_LT(std::abs(scene.missing()), 0.2 * retraction_over_radius * most);
  }
}

INSTANTIATE_TEST_SUITE_P(Motions, AngularMomentum, testing::Values("prescribed spin 2", "rigid/cds", "nve/cds implicit"));

// ---- steady turning --------------------------------------------------------------------------------------------------------------------------

namespace {

/// By how much a disc in the middle of a sheared fluid turns between t = 10 and 20, in steps in which it turns by 0.015.
double turned_by(const std::string &motion, int every)
{
  CoupledScene scene;
  scene.box("0 2 0 1", "p f p");
  scene.script("create_objects disk 1 0.5 diameter 0.25 points 26 density 1.5\nfix springs all mass_spring stiffness 100\nfix move all " + motion +
               "\nvelocity all ramp vx -0.5 0.5 y 0 1\nfix water all fluid/ib cells 64 32 density 1 viscosity 0.025 every " + std::to_string(every) +
               " wall ylo velocity -0.5 0 wall yhi velocity 0.5 0 initial_velocity linear\nfix disc all output/objects every " + std::to_string(every) +
               "\ntimestep " + std::to_string(0.03125 / every) + "\nrun " + std::to_string(320 * every) + "\n");
  const double before = scene.fix("disc")->compute_vector(13);
  scene.script("run " + std::to_string(320 * every) + "\n");
  return scene.fix("disc")->compute_vector(13) - before;
}

}  // namespace

/// What the fluid is asked for at the outline of a disc that turns must not depend on how often its points take a step on the way round.
TEST(SteadyTurning, IsTheSameHoweverTheDiscIsMoved)
{
  const double rigid = turned_by("rigid/cds", 1);
  EXPECT_NEAR(rigid, 4.7, 0.1);
  EXPECT_NEAR(turned_by("rigid/cds", 8), rigid, 0.01 * rigid);
  EXPECT_NEAR(turned_by("nve/cds implicit", 1), rigid, 0.01 * rigid);
  EXPECT_NEAR(turned_by("nve/cds", 16), rigid, 0.01 * rigid);
}
