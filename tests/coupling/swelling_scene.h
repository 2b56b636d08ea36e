// Objects that swell, for tests of fix swell: how scenes are made, read and compared.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <limits>
#include <string>

#include "dry_scene.h"

namespace swellflow_test {

using LAMMPS_NS::FixObjects;

/// Four discs that never meet, of which some lie on several ranks: how stiff contacts would be for their time step is no matter here.
inline constexpr const char *four_discs = "create_objects lattice 2 2 origin 0.25 0.25 spacing 0.5 disk diameter 0.12 points 20 density 1500 cds 0.2\n";
inline constexpr const char *springs_and_motion = "fix springs all mass_spring stiffness 100 restitution 0.1\nfix move all nve/cds\nfix flat all enforce2d\n";

inline void make_four(DryScene &scene, const std::string &swell, double step = 1e-2)
{
  scene.box("0 1 0 1");
  scene.script("guard warn\n" + std::string(four_discs) + springs_and_motion + "fix grow all swell " + swell + "\ntimestep " + std::to_string(step) + "\n");
}

/// A scene from a restart file, with `fixes` issued again.
inline void read_again(DryScene &scene, const std::string &file, const std::string &fixes)
{
  scene.script("atom_modify map array\nread_restart " + file + "\nnewton off\ncommunicate single vel yes\nsoft_particles yes\n");
  scene.settings();
  scene.script(fixes);
}

/// A file that lives as long as this, one for each number of ranks.
struct TestFile {
  explicit TestFile(const std::string &stem, const std::string &text = "") : name(stem + "_" + std::to_string(ranks()))
  {
    if (rank() == 0 && !text.empty()) std::ofstream(name) << text;
    MPI_Barrier(MPI_COMM_WORLD);
  }
  ~TestFile()
  {
    MPI_Barrier(MPI_COMM_WORLD);
    if (rank() == 0) std::remove(name.c_str());
  }
  std::string name;
};

/// Natural diameters of all own and ghost points; radii and masses of the points follow.
inline void expect_natural_diameter(const DryScene &scene, double wanted, double tolerance)
{
  const int all = scene.atom()->nlocal + scene.atom()->nghost;
  for (int i = 0; i < all; i++) {
    const double *point = scene.objects()->points()[i], *size = scene.objects()->sizes()[i], lambda = size[FixObjects::LAMBDA];
    EXPECT_NEAR(lambda * point[FixObjects::DIAMETER], wanted, tolerance);
    EXPECT_NEAR(scene.atom()->radius[i], lambda * size[FixObjects::CDS_RADIUS], 1e-15);
    EXPECT_NEAR(scene.atom()->rmass[i], lambda * lambda * size[FixObjects::MASS], 1e-12 * size[FixObjects::MASS]);
  }
}

/// A column of an object's points, own and ghosts, which all ranks must agree on bit for bit.
inline double same_on_all_points(const DryScene &scene, int object, double **values, int column)
{
  const double none = std::numeric_limits<double>::infinity();
  double bounds[2] = {none, none};  // smallest, - largest
  for (int i = 0; i < scene.atom()->nlocal + scene.atom()->nghost; i++) {
    const double value = values[i][column];
    if (scene.atom()->molecule[i] != object) continue;
    bounds[0] = std::min(bounds[0], value);
    bounds[1] = std::min(bounds[1], -value);
  }
  MPI_Allreduce(MPI_IN_PLACE, bounds, 2, MPI_DOUBLE, MPI_MIN, scene.lmp()->world);
  EXPECT_EQ(bounds[0], -bounds[1]) << "points of object " << object << " disagree";
  return bounds[0];
}

inline double column_of(const DryScene &scene, int object, FixObjects::Column column)
{
  return same_on_all_points(scene, object, scene.objects()->points(), column);
}

inline double swelling_ratio(const DryScene &scene, int object)
{
  return same_on_all_points(scene, object, scene.objects()->sizes(), FixObjects::LAMBDA);
}

inline double natural_diameter(const DryScene &scene, int object)
{
  return swelling_ratio(scene, object) * column_of(scene, object, FixObjects::DIAMETER);
}

}  // namespace swellflow_test
