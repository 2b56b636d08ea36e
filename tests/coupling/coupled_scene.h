// A LIGGGHTS scene with a fluid, in this process.
#pragma once

#include "coupling/coupled_fluid.h"
#include "dry_scene.h"

namespace swellflow_test {

class CoupledScene : public DryScene {
public:
  explicit CoupledScene(MPI_Comm comm = MPI_COMM_WORLD) : DryScene(comm) { swellflow::register_styles(lmp(), {swellflow::make_coupled_fluid, {}}); }

  /// A unit box of fluid under a lid that moves at 0.1, with `side` x `side` soft objects a third of a cell apart.
  void cavity(int side, double diameter, double density, double stiffness, int cells, int every, double fluid_step, const std::string &processors = "* * 1", int points = 20)
  {
    script("processors " + processors + "\n");
    box("0 1 0 1");
    for (const char *wall : {"xplane 0", "xplane 1", "yplane 0", "yplane 1"})
      script("fix w" + std::to_string(walls_++) + " all wall/gran model hooke/stiffness tangential history primitive type 1 " + wall + " absolute_damping on\n");
    const std::string gap = std::to_string(1.0 / side), first = std::to_string(0.5 / side);
    script("create_objects lattice " + std::to_string(side) + " " + std::to_string(side) + " origin " + first + " " + first + " spacing " + gap +
           " disk diameter " + std::to_string(diameter) + " points " + std::to_string(points) + " density " + std::to_string(density) + " cds 0.2 type 1\n");
    script("fix springs all mass_spring stiffness " + std::to_string(stiffness) + " restitution 1.0\nfix move all " + integrator + "\nfix flat all enforce2d\n");
    script("fix water all fluid/ib cells " + std::to_string(cells) + " " + std::to_string(cells) + " density 1000 viscosity 0.01 every " +
           std::to_string(every) + " wall yhi velocity 0.1 0\n");
    char step[64];
    std::snprintf(step, sizeof step, "timestep %.17g\n", fluid_step / every);
    script(step);
  }

  std::string integrator = "nve/cds";  ///< of the objects in cavity()

  double water(int n) { return fix("water")->compute_vector(n - 1); }

  double fastest_point() const
  {
    double largest = 0.0;
    for (int i = 0; i < atom()->nlocal; i++) largest = std::max(largest, std::hypot(atom()->v[i][0], atom()->v[i][1]));
    MPI_Allreduce(MPI_IN_PLACE, &largest, 1, MPI_DOUBLE, MPI_MAX, lmp()->world);
    return largest;
  }

private:
  int walls_ = 0;
};

}  // namespace swellflow_test
