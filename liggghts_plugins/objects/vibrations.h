// How fast the points of an object can vibrate on its springs, and so which explicit time step is stable; free of LIGGGHTS.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "spring_set.h"

namespace swellflow {

/// -d(force)/d(position) of all springs at these positions: ring points, then the hub.
Eigen::MatrixXd stiffness_matrix(const std::vector<Vector2> &x, const SpringSet &springs);

/// Whether dt is below `over_limit` times the largest stable step of velocity Verlet whose dashpots see the velocities of the half step before. With stiffness K, dashpots C,
/// masses M it is stable while dt^2/4 K + dt/2 C < M (von Neumann's condition, mode by mode): whether a matrix is positive definite, which one elimination tells.
bool step_is_below(const std::vector<Vector2> &x, const std::vector<double> &mass, const SpringSet &springs, double dt, double over_limit);

/// dt over that step, to 1e-6: the root of the largest eigenvalue of dt^2/4 K + dt/2 C over M, by bisection.
double step_over_limit(const std::vector<Vector2> &x, const std::vector<double> &mass, const SpringSet &springs, double dt);

/// A bound of the same from above, at the cost of one sum of forces (Gershgorin).
double bound_of_step_over_limit(const std::vector<Vector2> &x, const std::vector<double> &mass, const SpringSet &springs, double dt);

}  // namespace swellflow
