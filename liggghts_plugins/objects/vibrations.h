// How fast the points of an object can vibrate on its springs, and so which explicit time step is stable; free of LIGGGHTS.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "spring_set.h"

namespace swellflow {

/// -d(force)/d(position) of all springs at these positions: ring points, then the hub. Each dashpot adds `dashpots_per_time` times its constant to the
/// stiffness along its spring.
Eigen::MatrixXd stiffness_matrix(const std::vector<Vector2> &x, const SpringSet &springs, double dashpots_per_time = 0.0);

/// dt over the largest stable step of velocity Verlet whose dashpots see the velocities of the half step before. With stiffness K, dashpots C, masses M it is
/// stable while dt^2/4 K + dt/2 C < M (von Neumann's condition, mode by mode); the result is the root of the largest eigenvalue of the left side over the right.
double step_over_limit(const std::vector<Vector2> &x, const std::vector<double> &mass, const SpringSet &springs, double dt);

/// A bound of the same from above, at the cost of one sum of forces (Gershgorin): 1.1 to 1.6 times it for rings.
double bound_of_step_over_limit(const std::vector<Vector2> &x, const std::vector<double> &mass, const SpringSet &springs, double dt);

}  // namespace swellflow
