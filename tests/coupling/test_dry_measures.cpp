// What is measured of objects: contact forces and pressures against sums by hand, who touches whom, sums and means; on any number of ranks.
#include <numbers>

#include "liggghts_plugins/contact_forces.h"
#include "measured_objects.h"
#include "pair_forces.h"

using namespace swellflow_test;
using LAMMPS_NS::FixObjects;
using swellflow::ObjectMeasures;

namespace {

constexpr double kn = 1e4, pi = std::numbers::pi;

std::string wall(const std::string &name, const std::string &plane)
{
  return "fix " + name + " all wall/gran model hooke/stiffness tangential history primitive type 1 " + plane + " absolute_damping on\n";
}

void set_column(DryScene &scene, FixObjects::Column column, double value)
{
  for (int i = 0; i < scene.atom()->nlocal; i++)
    if (scene.objects()->is_point(i)) scene.objects()->points()[i][column] = value;
}

double polygon_area(int n, double radius) { return 0.5 * n * radius * radius * std::sin(2.0 * pi / n); }

}  // namespace

class Moved : public testing::TestWithParam<const char *> {};

// Damped springs, weight and a contact act together; what is left must be the contact, whoever moves the points.
TEST_P(Moved, ContactForcesAreWhatTheSpheresDo)
{
  DryScene scene;
  scene.box("0 1 0 1");
  scene.script("create_objects disk 0.37 0.5 diameter 0.2 points 16 density 1000 cds 0.2\ncreate_objects disk 0.62 0.53 diameter 0.2 points 16 density 1000 cds 0.2\n"
               "fix springs all mass_spring stiffness 1e4 restitution 0.5\nfix weight all gravity 9.81 vector 0 -1 0\nfix flat all enforce2d\n"
               "fix move all " + std::string(GetParam()) + "\ntimestep 1e-4\n");
  scene.change([](int tag, double *, double *v) { v[0] = tag > 17 ? -0.5 : 0.5; });
  for (const int steps : {0, 40, 40}) {
    scene.script("run " + std::to_string(steps) + "\n");
    const auto expected = pair_forces(scene.state(), 17, kn);
    double magnitudes[2] = {0.0, 0.0}, net[2][2] = {};
    for (const auto &[tag, f] : expected) {
      const int which = tag > 17;
      magnitudes[which] += std::hypot(f[0], f[1]);
      for (int d = 0; d < 2; d++) net[which][d] += f[d];
    }
    const LAMMPS_NS::ContactForces forces(scene.lmp());
    for (int i = 0; i < scene.atom()->nlocal; i++) {
      const auto found = expected.find(scene.atom()->tag[i]);
      for (int d = 0; d < 2; d++) EXPECT_NEAR(forces.on(i)[d], found == expected.end() ? 0.0 : found->second[d], 1e-8) << "atom " << scene.atom()->tag[i];
    }
    const Measures measures = measures_of(scene);
    ASSERT_EQ(measures.size(), 2u);
    EXPECT_GT(magnitudes[0], 50.0) << "there must be contact to compare";
    for (const auto &[id, object] : measures) {
      EXPECT_NEAR(object.contact_force, magnitudes[id - 1], 1e-8);
      EXPECT_EQ(object.coordination, 1);
      EXPECT_GT(object.contact_pressure, 0.0);
      for (int d = 0; d < 2; d++) EXPECT_NEAR(object.net_contact_force[d], net[id - 1][d], 1e-8);
    }
    for (int d = 0; d < 2; d++) EXPECT_NEAR(measures.at(1).net_contact_force[d] + measures.at(2).net_contact_force[d], 0.0, 1e-8);
  }
}

INSTANTIATE_TEST_SUITE_P(DryMeasures, Moved, testing::Values("nve/cds", "nve/cds implicit", "rigid/cds", "held"));

// Spheres on the x axis overlap by 0.001 and no others: each side gives 10 at 0.1 from the centre.
TEST(DryMeasures, PressureBetweenTwoPartners)
{
  DryScene scene;
  scene.box("0 1 0 1");
  scene.script("create_objects lattice 3 1 origin 0.221 0.5 spacing 0.279 disk diameter 0.2 points 20 density 1000 cds 0.2\nrun 0\n");
  const Measures measures = measures_of(scene);
  const double area = polygon_area(20, 0.1);
  EXPECT_NEAR(measures.at(1).contact_pressure, 10.0 * 0.1 / (2.0 * area), 1e-7);
  EXPECT_NEAR(measures.at(2).contact_pressure, 2.0 * 10.0 * 0.1 / (2.0 * area), 1e-7);
  EXPECT_NEAR(measures.at(2).contact_force, 20.0, 1e-8);
  EXPECT_NEAR(measures.at(2).net_contact_force[0], 0.0, 1e-8);
  EXPECT_NEAR(measures.at(3).net_contact_force[0], 10.0, 1e-8);
  EXPECT_EQ(measures.at(1).coordination, 1);
  EXPECT_EQ(measures.at(2).coordination, 2);
}

// The spheres at 90 and at 90 +- 18 degrees go into the walls. The outline lies 0.02 outside of the ring when the object has swollen by a half.
TEST(DryMeasures, PressureBetweenTwoWalls)
{
  constexpr double ring = 0.45, sphere = 0.09, offset = 0.02;
  DryScene scene;
  scene.box("0 1 0 1");
  scene.script("create_objects disk 0.5 0.5 diameter 0.6 points 20 density 1000 cds 0.1\nvariable grown equal 1.5\n" + wall("low", "yplane 0.0") +
               wall("high", "yplane 1.0"));
  set_column(scene, FixObjects::OUTLINE_OFFSET, offset / 1.5);
  scene.script("fix springs all mass_spring stiffness 100\nfix grow all swell ratio v_grown\nrun 0\n");
  scene.change([](int tag, double *x, double *) {
    if (tag > 1)
      for (int d = 0; d < 2; d++) x[d] = 0.5 + 1.5 * (x[d] - 0.5);
  });
  scene.script("run 0\n");
  const double high = ring + sphere - 0.5, low_y = ring * std::cos(0.1 * pi), low = low_y + sphere - 0.5;
  const double virial = 2.0 * kn * (high * ring + 2.0 * low * low_y);
  const ObjectMeasures disc = measures_of(scene).at(1);
  EXPECT_NEAR(disc.contact_pressure, virial / (2.0 * polygon_area(20, ring + offset)), 1e-6);
  EXPECT_NEAR(disc.contact_force, 2.0 * kn * (high + 2.0 * low), 1e-7);
  EXPECT_NEAR(disc.net_contact_force[1], 0.0, 1e-8);
  EXPECT_EQ(disc.coordination, 0);  // walls are not counted
  EXPECT_NEAR(disc.mean_diameter, 2.0 * (ring + offset), 1e-12);
  EXPECT_NEAR(disc.area, polygon_area(20, ring + offset), 1e-12);
  EXPECT_NEAR(disc.natural_diameter, 0.9, 1e-12);
  EXPECT_NEAR(disc.swelling_ratio, 1.5, 1e-12);
  EXPECT_NEAR(disc.spring_energy, 0.0, 1e-20);
}

TEST(DryMeasures, WithoutAPairStyleThereAreNoContacts)
{
  DryScene scene;
  scene.script("units si\ndimension 2\natom_style hybrid granular molecular\natom_modify map array\nboundary f f p\nnewton off\ncommunicate single vel yes\n"
               "region box block 0 1 0 1 -0.005 0.005 units box\ncreate_box 1 box\nneighbor 0.01 bin\nneigh_modify delay 0 exclude molecule all\n"
               "create_objects lattice 2 1 origin 0.3 0.5 spacing 0.25 disk diameter 0.2 density 1000 cds 0.2\nfix weight all gravity 9.81 vector 0 -1 0\nrun 0\n");
  for (const auto &[id, object] : measures_of(scene)) {
    EXPECT_EQ(object.contact_force, 0.0);
    EXPECT_EQ(object.contact_pressure, 0.0);
    EXPECT_EQ(object.coordination, 0);
  }
}

// ---- who touches whom ------------------------------------------------------------------------------------------------------------------------

// Spheres of neighbours overlap, those across the diagonal do not. Objects of the first row and column lie across periodic sides.
TEST(DryMeasures, CoordinationOfASquareLattice)
{
  DryScene scene;
  scene.box("0 1 0 1", "p p p");
  scene.script("create_objects lattice 4 4 origin 0.01 0.01 spacing 0.25 disk diameter 0.2 points 20 density 1000 cds 0.2\nrun 0\n");
  const Measures measures = measures_of(scene);
  ASSERT_EQ(measures.size(), 16u);
  for (const auto &[id, object] : measures) {
    EXPECT_EQ(object.coordination, 4) << id;
    EXPECT_NEAR(object.contact_pressure, measures.at(1).contact_pressure, 1e-8 * measures.at(1).contact_pressure);
    EXPECT_NEAR(object.net_contact_force[0], 0.0, 1e-8);
  }
  EXPECT_GT(measures.at(1).contact_pressure, 100.0);
}

TEST(DryMeasures, CoordinationOfChains)
{
  for (const bool closed : {false, true}) {
    DryScene scene;
    scene.box("0 1 0 1", closed ? "p f p" : "f f p");
    scene.script("create_objects lattice 4 1 origin 0.125 0.5 spacing 0.25 disk diameter 0.2 points 20 density 1000 cds 0.2\nrun 0\n");
    for (const auto &[id, object] : measures_of(scene)) EXPECT_EQ(object.coordination, closed || id == 2 || id == 3 ? 2 : 1) << id;
  }
}

// Two objects that touch twice, directly and across the periodic side, are one partner each.
TEST(DryMeasures, APartnerOnBothSidesCountsOnce)
{
  DryScene scene;
  scene.box("0 0.5 0 1", "p f p");
  scene.script("create_objects lattice 2 1 origin 0.01 0.5 spacing 0.25 disk diameter 0.2 points 20 density 1000 cds 0.2\nrun 0\n");
  for (const auto &[id, object] : measures_of(scene)) {
    EXPECT_EQ(object.coordination, 1);
    EXPECT_NEAR(object.net_contact_force[0], 0.0, 1e-8);
  }
}

// Foreign atoms are partners too; a sphere that takes part in no contact makes none.
TEST(DryMeasures, ForeignAtomsCountAndPointsWithoutSpheresDoNot)
{
  DryScene scene;
  scene.box("0 1 0 1");
  scene.script("create_objects disk 0.5 0.5 diameter 0.2 points 20 density 1000 cds 0.2\n"
               "create_atoms 1 single 0.66 0.5 0\ncreate_atoms 1 single 0.5 0.66 0\ncreate_atoms 1 single 0.2 0.2 0\n"
               "group grains id 22 23 24\nset group grains diameter 0.06 density 1000\nrun 0\n");
  EXPECT_EQ(measures_of(scene).at(1).coordination, 2);
  for (int i = 0; i < scene.atom()->nlocal; i++)
    if (scene.atom()->tag[i] == 2) scene.objects()->points()[i][FixObjects::HAS_CDS] = 0.0;  // that on the x axis
  scene.script("run 0\n");
  EXPECT_EQ(measures_of(scene).at(1).coordination, 1);
}

TEST(DryMeasures, RanksMakeNoDifference)
{
  const auto bed = [](MPI_Comm comm) {
    DryScene scene(comm);
    scene.box("0 1 0 1", "p f p");
    scene.script("create_objects lattice 4 4 origin 0.02 0.13 spacing 0.25 disk diameter 0.18 points 20 density 1500 cds 0.2\n" + wall("low", "yplane 0.0") +
                 wall("high", "yplane 1.0") +
                 "fix springs all mass_spring stiffness 1000 restitution 0.9\nfix grow all swell linear rate 0.05 max 0.25\nfix move all nve/cds\n"
                 "fix weight all gravity 0.1 vector 0 -1 0\nfix flat all enforce2d\ntimestep 2e-3\n");
    scene.change([](int tag, double *, double *v) { v[0] = 0.5 + 0.1 * std::sin(1.0 * tag), v[1] = 0.1 * std::cos(2.0 * tag); });
    scene.script("run 300\n");
    return measures_of(scene);
  };
  const Measures many = bed(MPI_COMM_WORLD), one = bed(MPI_COMM_SELF);
  ASSERT_EQ(many.size(), one.size());
  double touching = 0.0, turned = 0.0;
  for (const auto &[id, object] : many) {
    const ObjectMeasures &other = one.at(id);
    EXPECT_EQ(object.coordination, other.coordination) << id;
    swellflow::for_each_measure({}, [&](const char *name, const std::string &, auto member) {
      if constexpr (std::is_same_v<decltype(member), double ObjectMeasures::*>) {
        EXPECT_NEAR(object.*member, other.*member, 1e-7 * (1.0 + std::abs(other.*member))) << name << " of " << id;
      }
    });
    for (int d = 0; d < 2; d++) EXPECT_NEAR(object.velocity[d], other.velocity[d], 1e-9);
    touching += object.coordination;
    turned = std::max(turned, std::abs(object.rotation));
  }
  EXPECT_GT(touching, 16.0);
  EXPECT_GT(turned, 0.01);
}

// ---- values of the fix -----------------------------------------------------------------------------------------------------------------------

TEST(DryMeasures, NothingBeforeTheFirstRun)
{
  DryScene scene;
  scene.box("0 1 0 1");
  scene.script("create_objects lattice 2 2 origin 0.3 0.3 spacing 0.4 disk diameter 0.2 points 12 density 1000 cds 0.1\nfix sums all output/objects every 1\n");
  EXPECT_TRUE(measures_of(scene).empty());
  EXPECT_EQ(scene.fix("sums")->compute_scalar(), 0.0);
  scene.script("run 0\n");
  EXPECT_EQ(measures_of(scene).size(), 4u);
  EXPECT_EQ(scene.fix("sums")->compute_scalar(), 4.0);
  scene.script("group one molecule 1\ndelete_atoms group one compress no\n");
  EXPECT_TRUE(measures_of(scene).empty());  // until ghosts are known again
  scene.script("run 0\n");
  EXPECT_EQ(measures_of(scene).size(), 3u);
}

TEST(DryMeasures, ValuesAreSumsAndMeans)
{
  DryScene scene;
  scene.box("0 1 0 1");
  scene.script("create_objects disk 0.3 0.3 diameter 0.2 points 16 density 1000 cds 0.2\ncreate_objects disk 0.5 0.5 diameter 0.3 points 16 density 1000 cds 0.2\n"
               "create_objects disk 0.8 0.8 diameter 0.25 points 16 density 1000 cds 0.2\n"
               "fix springs all mass_spring stiffness 1000\nfix move all nve/cds\nfix weight all gravity 9.81 vector 0 -1 0\ntimestep 1e-4\n"
               "group some molecule 1 3\nfix sums all output/objects every 10\nfix two some output/objects every 10\nfix one all output/objects every 10 objects 3\nrun 30\n");
  const Measures measures = measures_of(scene);
  const auto value = [&](const char *id, int n) { return scene.fix(id)->compute_vector(n - 1); };
  const auto expect = [&](const char *id, std::vector<int> members) {
    double n = members.size(), sum[14] = {}, most[3] = {1e300, -1e300, 0.0};
    for (int member : members) {
      const ObjectMeasures &o = measures.at(member);
      const double values[] = {o.mean_diameter, o.diameter_of_area, 0.0, o.area, o.aspect_ratio, o.spring_energy, o.kinetic_energy, o.contact_pressure, o.contact_force,
                               1.0 * o.coordination, std::abs(o.rotation), o.velocity[0], o.velocity[1], o.centroid[1]};
      for (int k = 0; k < 14; k++) sum[k] += values[k];
      most[0] = std::min(most[0], o.area_ratio), most[1] = std::max(most[1], o.contact_pressure), most[2] = std::max(most[2], std::abs(o.rotation));
    }
    for (int member : members) sum[2] += std::pow(measures.at(member).mean_diameter - sum[0] / n, 2);
    const double expected[] = {n, sum[0] / n, sum[1] / n, std::sqrt(sum[2] / n), sum[3], sum[4] / n, most[0], sum[5], sum[6], sum[7] / n, most[1], sum[8], sum[9] / n,
                               sum[10] / n, most[2], sum[11] / n, sum[12] / n, sum[13] / n};
    for (int k = 1; k <= 18; k++) EXPECT_NEAR(value(id, k), expected[k - 1], 1e-10 * (1.0 + std::abs(expected[k - 1]))) << id << " " << k;
  };
  expect("sums", {1, 2, 3});
  expect("two", {1, 3});
  expect("one", {3});
  EXPECT_EQ(value("sums", 1), 3.0);
  EXPECT_GT(value("sums", 13), 0.5);
}
