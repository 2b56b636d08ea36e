// Where the volume goes that objects swell by: they drink it in a closed box, or push it out of an open one.
#include "coupled_scene.h"
#include "coupling/dem_engine.h"
#include "coupling/growth_sources.h"
#include "liggghts_plugins/fix_fluid_ib.h"
#include "liggghts_plugins/object_geometry.h"
#include "liggghts_plugins/objects/outline.h"

using namespace swellflow_test;
using swellflow::Vector2;

namespace {

/// The velocity in the cells, of all ranks, and between their centres.
class Velocity {
public:
  explicit Velocity(const CoupledScene &scene)
  {
    const auto &fluid = *dynamic_cast<LAMMPS_NS::FixFluidIb &>(*scene.fix("water")).partner();
    const swellflow::FieldBlock block = fluid.field_block();
    std::vector<double> own;
    fluid.copy_field("velocity", own);
    nx_ = block.global_cells[0];
    ny_ = block.global_cells[1];
    h_ = block.spacing;
    values_.assign(3 * nx_ * ny_, 0.0);
    std::copy(own.begin(), own.end(), values_.begin() + 3 * nx_ * block.first[1]);
    MPI_Allreduce(MPI_IN_PLACE, values_.data(), values_.size(), MPI_DOUBLE, MPI_SUM, scene.lmp()->world);
  }
  Vector2 at(const Vector2 &x) const
  {
    const double i = x.x() / h_ - 0.5, j = x.y() / h_ - 0.5;
    const int i0 = std::clamp(static_cast<int>(i), 0, nx_ - 2), j0 = std::clamp(static_cast<int>(j), 0, ny_ - 2);
    Vector2 u = Vector2::Zero();
    for (int a = 0; a < 2; a++)
      for (int b = 0; b < 2; b++) {
        const double weight = (a ? i - i0 : 1.0 - (i - i0)) * (b ? j - j0 : 1.0 - (j - j0));
        const double *cell = &values_[3 * ((j0 + b) * nx_ + i0 + a)];
        u += weight * Vector2(cell[0], cell[1]);
      }
    return u;
  }

private:
  int nx_, ny_;
  double h_;
  std::vector<double> values_;
};

/// Flux of the fluid through the outline, and of its magnitude, by the midpoints of pieces of the outline that are shorter than a cell; and the area inside. By object.
struct Outlines {
  explicit Outlines(const CoupledScene &scene, int count) : flux(count, 0.0), magnitude(count, 0.0), area(count, 0.0)
  {
    const Velocity u(scene);
    for (const auto &object : scene.objects()->objects()) {
      if (!scene.objects()->owns(object)) continue;
      const int id = scene.atom()->molecule[object.hub] - 1;
      const Vector2 hub(scene.atom()->x[object.hub][0], scene.atom()->x[object.hub][1]);
      const std::vector<Vector2> outline = LAMMPS_NS::outline_of(scene.lmp(), object);
      area[id] = swellflow::outline_shape(outline).area;
      for (std::size_t k = 0; k < outline.size(); k++) {
        const Vector2 &a = outline[k], edge = outline[(k + 1) % outline.size()] - a;
        constexpr int pieces = 8;
        for (int p = 0; p < pieces; p++) {
          const Vector2 v = u.at(hub + a + (p + 0.5) / pieces * edge);
          const double through = (v.x() * edge.y() - v.y() * edge.x()) / pieces;
          flux[id] += through;
          magnitude[id] += std::abs(through);
        }
      }
    }
    for (auto *sums : {&flux, &magnitude, &area}) MPI_Allreduce(MPI_IN_PLACE, sums->data(), count, MPI_DOUBLE, MPI_SUM, scene.lmp()->world);
  }
  std::vector<double> flux, magnitude, area;
};

TEST(GrowthSources, FollowTheOutlineTowardsItsNaturalArea)
{
  using swellflow::followed_area;
  EXPECT_EQ(followed_area(1.0, 1.1, 1.2), 1.1);
  EXPECT_EQ(followed_area(1.0, 1.3, 1.2), 1.2);  // pulled larger than it is meant to be
  EXPECT_EQ(followed_area(1.0, 0.9, 1.2), 1.0);  // pressed
  EXPECT_EQ(followed_area(1.0, 0.9, 0.8), 0.9);  // shrinking
  EXPECT_EQ(followed_area(1.0, 0.7, 0.8), 0.8);
  EXPECT_EQ(followed_area(1.0, 1.1, 0.8), 1.0);
}

// Shares are areas: they sum to 1 and have the centroid of the area, whatever the hub. What is folded back has none.
TEST(GrowthSources, FillTheInside)
{
  const std::vector<Vector2> kite = {{2.0, 0.1}, {0.2, 1.0}, {-0.7, 0.0}, {0.1, -0.8}};
  std::vector<swellflow::SourcePoint> points(1, {{9.0, 9.0}, 7.0});
  swellflow::add_source_points(kite, {10.0, 20.0}, 0.02, points);
  double sum = 0.0;
  Vector2 mean = Vector2::Zero();
  for (std::size_t p = 1; p < points.size(); p++) {
    EXPECT_GT(points[p].share, 0.0);
    sum += points[p].share;
    mean += points[p].share * Vector2(points[p].x[0] - 10.0, points[p].x[1] - 20.0);
  }
  EXPECT_EQ(points[0].share, 7.0);
  EXPECT_NEAR(sum, 1.0, 1e-12);
  EXPECT_NEAR((mean - swellflow::outline_shape(kite).centroid).norm(), 0.0, 1e-3);
  EXPECT_GT(points.size(), swellflow::outline_shape(kite).area / (0.02 * 0.02));

  points.clear();
  swellflow::add_source_points({{1.0, 0.0}, {-1.0, -0.5}, {-1.0, 0.5}}, {0.0, 0.0}, 0.1, points);  // clockwise
  ASSERT_EQ(points.size(), 1u);
  EXPECT_EQ(points[0].share, 1.0);
}

// The outline gains dA/dt, the fluid within its flux through the outline: what the object drinks is the difference. In a closed box of incompressible fluid that is all of it.
TEST(Absorb, WhatAnObjectDrinksIsWhatItsOutlineGains)
{
  CoupledScene scene;
  scene.integrator = "nve/cds implicit";
  scene.cavity(2, 0.25, 1500.0, 1000.0, 80, 1, 5e-3, "* * 1", 40);
  scene.script("fix grow all swell linear rate 0.01 max 0.5\nrun 100\n");
  for (int sample = 0; sample < 5; sample++) {
    const Outlines before(scene, 4);
    scene.script("run 10\n");
    const Outlines after(scene, 4);
    for (int object = 0; object < 4; object++) {
      const double growth = (after.area[object] - before.area[object]) / 0.05, flux = 0.5 * (before.flux[object] + after.flux[object]);
      EXPECT_GT(after.magnitude[object], 0.2 * growth) << "the lid must move the fluid through the outlines";
      EXPECT_NEAR(growth - flux, growth, 0.01 * growth);
    }
  }
}

// A closed box of incompressible fluid: an object that drinks grows as it is told.
TEST(Absorb, AnObjectThatDrinksGrowsInAClosedBox)
{
  CoupledScene scene;
  scene.cavity(1, 0.3, 1500.0, 1000.0, 50, 10, 5e-3, "* * 1", 60);
  scene.script("fix grow all swell linear rate 0.02 max 0.5\nrun 10000\n");
  const double natural = scene.fix("grow")->compute_vector(0);
  EXPECT_NEAR(natural, 0.4, 1e-12);
  EXPECT_NEAR(scene.fix("grow")->compute_vector(2), natural, 0.005 * natural);
  EXPECT_LT(scene.water(8), 1e-12);
}

/// Objects that push the water away, in a box that is open at its upper side.
class OpenBox : public CoupledScene {
public:
  OpenBox(const std::string &integrator, int every, const std::string &objects, const std::string &swell, const std::string &water = "outflow yhi")
  {
    box("0 1 0 1");
    for (const char *wall : {"xplane 0", "xplane 1", "yplane 0", "yplane 1"})
      script("fix w" + std::to_string(walls_++) + " all wall/gran model hooke/stiffness tangential history primitive type 1 " + wall + " absolute_damping on\n");
    script("create_objects " + objects + " points 40 density 1500 cds 0.1 type 1\nfix springs all mass_spring stiffness 1e4 restitution 0.5\n" +
           "fix grow all swell " + swell + " absorb no\nfix move all " + integrator + "\nfix flat all enforce2d\n" +
           "fix water all fluid/ib cells 64 64 density 1000 viscosity 0.01 every " + std::to_string(every) + " " + water + "\ntimestep " +
           std::to_string(step_ / every) + "\n");
    every_ = every;
  }
  double outline_area() { return fix("grow")->compute_vector(5); }
  /// Volume that left, and what the outlines gained.
  std::array<double, 2> fluid_step()
  {
    const double before = outline_area();
    script("run " + std::to_string(every_) + "\n");
    return {water(19) * water(10), outline_area() - before};
  }

private:
  static constexpr double step_ = 5e-3;
  int every_, walls_ = 0;
};

class PushesOut : public testing::TestWithParam<std::tuple<const char *, int>> {};

// Two discs that grow until they press each other and the walls: in each step as much water leaves as their outlines gain, and never comes back.
TEST_P(PushesOut, AsMuchAsObjectsGrow)
{
  const auto [integrator, every] = GetParam();
  OpenBox scene(integrator, every, "lattice 2 1 origin 0.26 0.5 spacing 0.48 disk diameter 0.3", "linear rate 0.1 max 0.5");
  scene.script("run 0\n");
  const double start = scene.outline_area();
  double left = 0.0;
  const int steps = ranks() == 1 ? 300 : 40;
  for (int s = 0; s < steps; s++) {
    const auto [out, gained] = scene.fluid_step();
    if (s == 39) {
      EXPECT_NEAR(scene.fix("grow")->compute_vector(2), scene.fix("grow")->compute_vector(0), 5e-3 * 0.3) << "nothing holds them back";
    }
    EXPECT_GE(out, -1e-15);
    if (s < 40) {  // not pressed yet
      EXPECT_NEAR(out, gained, 1e-10 * start) << "step " << s;
    }
    left += out;
  }
  EXPECT_GT(left, 0.01 * start);
  EXPECT_NEAR(left, scene.outline_area() - start, 1e-3 * start);
  EXPECT_LT(scene.water(3), 1e-10) << "divergence, less what grows";
  EXPECT_LT(scene.water(8), 1e-12);
}
INSTANTIATE_TEST_SUITE_P(Integrators, PushesOut, testing::Combine(testing::Values("nve/cds", "nve/cds implicit", "rigid/cds"), testing::Values(1, 4)));

}  // namespace
