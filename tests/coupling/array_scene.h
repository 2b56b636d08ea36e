// One disc in a periodic box, a square array: solid fraction 0.1, 48 cells from disc to disc; box, viscosity and density are 1.
#pragma once

#include "coupled_scene.h"

namespace swellflow_test {

struct DiscArray {
  double z = 4.0;  ///< fluid step over h^2 / nu
  double x = 0.5, y = 0.5;
  std::string variables;  ///< lines that declare them
  std::string motion = "held";
  std::string fluid = "mean_velocity x 1 mean_velocity y 0 advection none";
};

class ArrayScene : public CoupledScene {
public:
  static constexpr int cells = 48;

  explicit ArrayScene(const DiscArray &array, MPI_Comm comm = MPI_COMM_WORLD) : CoupledScene(comm)
  {
    const auto number = [](double x) {
      char text[32];
      std::snprintf(text, sizeof text, "%.17g", x);
      return std::string(text);
    };
    const std::string n = std::to_string(cells);
    script(array.variables);
    script("units si\ndimension 2\natom_style hybrid granular molecular\natom_modify map array\nboundary p p p\nnewton off\ncommunicate single vel yes\n"
           "region box block 0 1 0 1 -0.5 0.5 units box\ncreate_box 1 box\n"
           "create_objects disk " + number(array.x) + " " + number(array.y) + " diameter " + number(diameter) + " points 54 density 1\n"
           "fix disc all " + array.motion + "\nfix water all fluid/ib cells " + n + " " + n + " density 1 viscosity 1 " + array.fluid + "\n"
           "timestep " + number(array.z / (cells * cells)) + "\n");
  }

  void run(int steps) { script("run " + std::to_string(steps) + "\n"); }
  double drag() { return disc(1); }
  double disc(int n) { return fix("disc")->compute_vector(n - 1); }

  void run_for(double time) { run(static_cast<int>(std::lround(time / lmp()->update->dt))); }

private:
  static constexpr double diameter = 0.35682482323055424;  // 2 sqrt(0.1 / pi)
};

}  // namespace swellflow_test
