// A wall that LIGGGHTS reads as a mesh.
#pragma once

#include <cstdio>
#include <fstream>
#include <initializer_list>

#include "dry_scene.h"

namespace swellflow_test {

/// A wall of triangles from a to b, a strip about z = 0; the name of its file.
inline std::string write_mesh(const std::string &kind, std::array<double, 2> a, std::array<double, 2> b)
{
  const std::string name = kind + "_" + std::to_string(ranks()) + ".stl";
  if (rank() == 0) {
    std::ofstream file(name);
    file << "solid wall\n";
    const auto triangle = [&](std::initializer_list<std::array<double, 3>> corners) {
      file << "facet normal 0 1 0\nouter loop\n";
      for (const auto &c : corners) file << "vertex " << c[0] << " " << c[1] << " " << c[2] << "\n";
      file << "endloop\nendfacet\n";
    };
    const int n = 10;
    for (int k = 0; k < n; k++) {
      const auto at = [&](int i, double z) {
        return std::array<double, 3>{a[0] + (b[0] - a[0]) * i / n, a[1] + (b[1] - a[1]) * i / n, z};
      };
      triangle({at(k, -0.05), at(k + 1, -0.05), at(k + 1, 0.05)});
      triangle({at(k, -0.05), at(k + 1, 0.05), at(k, 0.05)});
    }
    file << "endsolid wall\n";
  }
  MPI_Barrier(MPI_COMM_WORLD);
  return name;
}

inline void remove_mesh(const std::string &name)
{
  MPI_Barrier(MPI_COMM_WORLD);
  if (rank() == 0) std::remove(name.c_str());
}

inline constexpr const char *mesh_wall =
    "fix wall all wall/gran model hooke/stiffness tangential history mesh n_meshes 1 meshes mesh absolute_damping on\n";
/// The reach of the box in z: LIGGGHTS sends a mesh's images across thin periodic boxes, and stumbles over them.
inline constexpr const char *thick = "-0.5 0.5";

}  // namespace swellflow_test
