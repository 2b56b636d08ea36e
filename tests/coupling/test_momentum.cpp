// Momentum of fluid, objects and walls together, over hundreds of steps with all that exchanges it.
#include "coupled_scene.h"
#include "liggghts_plugins/fluid_columns.h"

#include "fix_property_atom.h"

using namespace swellflow_test;
using swellflow::FluidAhead;
using swellflow::FluidLaw;
using swellflow::FluidHome;

namespace {

using Plane = std::array<double, 2>;

/// Two discs that swell while they fall, the lower one onto the floor and the upper one onto it, under a moving lid.
///
/// The account. Fluid: its momentum changes by what sides and objects give. Objects: by what they receive from the fluid around; by the inertia and the weight of the fluid inside, which is
/// given back to them; by the forces on their points, which are walls and weight (springs and contacts of objects with each other have no sum); and by the mass that swelling adds,
/// which comes with the velocity of its point: (m' - m) v between the two half kicks of a step. The part of a velocity that is foreseen at the end of a step does not count.
class Falling : public CoupledScene {
public:
  Falling(const std::string &integrator, int every, double mass_ratio) : explicit_(integrator == "nve/cds"), every_(every)
  {
    box("0 1 0 1");
    for (const char *wall : {"xplane 0", "xplane 1", "yplane 0", "yplane 1"}) {
      walls_.push_back("w" + std::to_string(walls_.size()));
      script("fix " + walls_.back() + " all wall/gran model hooke/stiffness tangential history primitive type 1 " + wall + " store_force yes absolute_damping on\n");
    }
    for (const char *centre : {"0.42 0.17", "0.55 0.50"})
      script(std::string("create_objects disk ") + centre + " diameter 0.3 points 20 density " + std::to_string(1000.0 * mass_ratio) + " cds 0.2 type 1\n");
    script("fix springs all mass_spring stiffness 1000 restitution 0.8\nfix grow all swell linear rate 0.02 max 0.4\nfix move all " + integrator +
           "\nfix flat all enforce2d\nfix weight all gravity 2 vector 0.1 -1 0\nfix water all fluid/ib cells 48 48 density 1000 viscosity 0.01 every " +
           std::to_string(every) + " wall yhi velocity 0.1 0\ntimestep " + std::to_string(5e-3 / every) + "\nrun " + std::to_string(every) + "\n");
    momentum_ = objects_momentum();
    fluid_ = {water(17), water(18)};
    forces_ = outer_forces();
    masses_ = of_objects([this](int i, Plane &sum) { sum[0] += atom()->rmass[i]; });
  }

  void fluid_step()
  {
    for (int s = 0; s < every_; s++) dem_step();
    const double dt = water(10);
    const Plane fluid{water(17), water(18)};
    for (int d = 0; d < 2; d++) {
      const double by_sides = dt * water(15 + d), to_objects = dt * water(6 + d);
      fluid_error_[d] += fluid[d] - fluid_[d] - by_sides + to_objects;
      received_[d] += to_objects;
      exchanged_ += std::abs(to_objects);
    }
    fluid_ = fluid;
    const Plane objects = objects_momentum(), inner_force = of_fluid_inside();
    for (int d = 0; d < 2; d++) pushed_[d] += dt * inner_force[d];
    for (int d = 0; d < 2; d++) objects_error_[d] += objects[d] - momentum_[d] - received_[d] - pushed_[d] - brought_[d];
    momentum_ = objects;
    received_ = pushed_ = brought_ = {};
  }

  Plane fluid_error() const { return {fluid_error_[0] / exchanged_, fluid_error_[1] / exchanged_}; }
  Plane objects_error() const { return {objects_error_[0] / exchanged_, objects_error_[1] / exchanged_}; }
  double by_walls() const { return by_walls_; }
  double by_swelling() const { return by_swelling_; }
  double exchanged() const { return exchanged_; }

private:
  using Sums = std::array<Plane, 2>;  // by object

  template <class Visit> Sums of_objects(const Visit &visit) const
  {
    Sums sums{};
    for (int i = 0; i < atom()->nlocal; i++) visit(i, sums[atom()->molecule[i] - 1]);
    MPI_Allreduce(MPI_IN_PLACE, sums.data(), 4, MPI_DOUBLE, MPI_SUM, lmp()->world);
    return sums;
  }
  double **property(const std::string &name) const { return static_cast<LAMMPS_NS::FixPropertyAtom *>(fix(name))->array_atom; }
  Plane objects_momentum() const
  {
    Plane sum{};
    for (const Plane &object : momenta())
      for (int d = 0; d < 2; d++) sum[d] += object[d];
    return sum;
  }
  Sums momenta() const
  {
    return of_objects([this](int i, Plane &sum) {
      for (int d = 0; d < 2; d++) sum[d] += atom()->rmass[i] * velocity(i, d);
    });
  }
  double velocity(int i, int d) const { return atom()->v[i][d] - property(FluidAhead::NAME)[i][FluidAhead::AHEAD_X + d]; }
  Plane of_fluid_inside() const
  {
    const Sums sums = of_objects([this](int i, Plane &sum) {
      for (int d = 0; d < 2; d++) sum[d] += property(FluidHome::NAME)[i][FluidHome::INNER_FORCE_X + d];
    });
    return {sums[0][0] + sums[1][0], sums[0][1] + sums[1][1]};
  }
  Plane outer_forces()
  {
    const double weight = 2.0 / std::hypot(0.1, 1.0);
    Plane walls{}, all{};
    for (int i = 0; i < atom()->nlocal; i++)
      for (int d = 0; d < 2; d++) {
        for (const std::string &id : walls_) walls[d] += property("force_" + id)[i][d];
        all[d] += atom()->rmass[i] * weight * (d ? -1.0 : 0.1);
      }
    MPI_Allreduce(MPI_IN_PLACE, walls.data(), 2, MPI_DOUBLE, MPI_SUM, lmp()->world);
    MPI_Allreduce(MPI_IN_PLACE, all.data(), 2, MPI_DOUBLE, MPI_SUM, lmp()->world);
    for (int d = 0; d < 2; d++) {
      all[d] += walls[d];
      by_walls_ += std::abs(walls[d]) * lmp()->update->dt;
    }
    return all;
  }

  void dem_step()
  {
    script("run 1 pre no post no\n");
    const double half = 0.5 * lmp()->update->dt;
    const Plane forces = outer_forces();
    for (int d = 0; d < 2; d++) pushed_[d] += half * (forces_[d] + forces[d]);
    forces_ = forces;
    book_swelling(half);
  }

  /// Momentum of an object between the two half kicks, with the masses after it has grown: that at the end less what the second half kick gave.
  void book_swelling(double half)
  {
    double **law = property(FluidLaw::NAME);
    const Sums between = of_objects([&](int i, Plane &sum) {
      for (int d = 0; d < 2; d++) {
        const double v = velocity(i, d), fluid = explicit_ ? law[i][FluidLaw::A_X + d] - law[i][FluidLaw::KAPPA] * v : 0.0;
        sum[d] += atom()->rmass[i] * v - half * (atom()->f[i][d] + fluid);
      }
    });
    const Sums masses = of_objects([this](int i, Plane &sum) { sum[0] += atom()->rmass[i]; });
    for (int object = 0; object < 2; object++)
      for (int d = 0; d < 2; d++) {
        const double brought = (1.0 - masses_[object][0] / masses[object][0]) * between[object][d];
        brought_[d] += brought;
        by_swelling_ += std::abs(brought);
      }
    masses_ = masses;
  }

  bool explicit_;
  int every_;
  std::vector<std::string> walls_;
  Plane fluid_{}, momentum_{}, forces_{}, received_{}, pushed_{}, brought_{}, fluid_error_{}, objects_error_{};
  Sums masses_{};
  double exchanged_ = 0.0, by_walls_ = 0.0, by_swelling_ = 0.0;
};

struct Scene {
  const char *integrator;
  int every;
  double mass_ratio;
};

class Momentum : public testing::TestWithParam<Scene> {};

TEST_P(Momentum, OfFluidObjectsAndWallsBalances)
{
  const auto [integrator, every, mass_ratio] = GetParam();
  Falling scene(integrator, every, mass_ratio);
  const int steps = ranks() == 1 ? 400 : 150;
  for (int s = 0; s < steps; s++) scene.fluid_step();
  for (int d = 0; d < 2; d++) {
    EXPECT_NEAR(scene.fluid_error()[d], 0.0, 1e-10);
    EXPECT_NEAR(scene.objects_error()[d], 0.0, 1e-10);
  }
  EXPECT_GT(scene.by_walls(), ranks() == 1 ? 1e-2 * scene.exchanged() : 0.0) << "an object must reach the floor";
  EXPECT_GT(scene.by_swelling(), 1e-4 * scene.exchanged());
}

INSTANTIATE_TEST_SUITE_P(Integrators, Momentum,
                         testing::Values(Scene{"nve/cds", 4, 1.5}, Scene{"nve/cds implicit", 1, 1.5}, Scene{"nve/cds implicit", 3, 3.0},
                                         Scene{"nve/cds implicit energy conserve", 2, 1.5}, Scene{"rigid/cds", 1, 1.5}, Scene{"rigid/cds", 4, 3.0},
                                         Scene{"nve/cds implicit", 1, 0.1}, Scene{"rigid/cds", 1, 0.1}, Scene{"nve/cds", 8, 1.0}));

}  // namespace
