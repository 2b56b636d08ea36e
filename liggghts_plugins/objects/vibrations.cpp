#include "vibrations.h"

#include <algorithm>

#include "ring_solver.h"

namespace swellflow {

namespace {

/// Tension over length: a pull keeps points from moving sideways, a push helps them to.
double sideways_stiffness(const Vector2 &d, const Spring &spring)
{
  const double xi = d.norm();
  return xi > 0.0 ? spring.stiffness * (1.0 - spring.length / xi) : spring.stiffness;
}

/// visit(a, b, block): -d(force on a)/d(x_a) of each spring. Each dashpot adds `dashpots_per_time` times its constant to the stiffness along its spring.
template <typename Visit>
void for_each_block(const std::vector<Vector2> &x, const SpringSet &springs, double dashpots_per_time, const Visit &visit)
{
  for_each_spring(springs, [&](int a, int b, const Spring &spring) {
    const Vector2 d = x[a] - x[b], along = Direction(x[a], x[b]).n;
    const double axial = spring.stiffness + dashpots_per_time * spring.dashpot, sideways = sideways_stiffness(d, spring);
    visit(a, b, Matrix2(sideways * Matrix2::Identity() + (axial - sideways) * along * along.transpose()));
  });
}

}  // namespace

Eigen::MatrixXd stiffness_matrix(const std::vector<Vector2> &x, const SpringSet &springs)
{
  const int n = springs.held_points();
  Eigen::MatrixXd K = Eigen::MatrixXd::Zero(2 * n, 2 * n);
  for_each_block(x, springs, 0.0, [&](int a, int b, const Matrix2 &block) {
    for (const int i : {a, b}) K.block<2, 2>(2 * i, 2 * i) += block;
    K.block<2, 2>(2 * a, 2 * b) -= block;
    K.block<2, 2>(2 * b, 2 * a) -= block;
  });
  return K;
}

bool step_is_below(const std::vector<Vector2> &x, const std::vector<double> &mass, const SpringSet &springs, double dt, double over_limit)
{
  RingSolver difference;
  difference.start(springs.ring_points(), springs.has_spokes());
  const double scale = 0.25 * dt * dt / (over_limit * over_limit);
  for (int i = 0; i < springs.held_points(); ++i) difference.diagonal(i) = mass[i] * Matrix2::Identity();
  for_each_block(x, springs, 2.0 / dt, [&](int a, int b, const Matrix2 &block) {
    difference.diagonal(a) -= scale * block;
    difference.diagonal(b) -= scale * block;
    difference.coupling(a, b) += scale * block;
  });
  return difference.solve();
}

double step_over_limit(const std::vector<Vector2> &x, const std::vector<double> &mass, const SpringSet &springs, double dt)
{
  double high = bound_of_step_over_limit(x, mass, springs, dt), low = 0.5 * high;
  while (low > 0.0 && step_is_below(x, mass, springs, dt, low)) {
    high = low;
    low *= 0.5;
  }
  while (high - low > 1e-6 * high) {
    const double middle = 0.5 * (low + high);
    (step_is_below(x, mass, springs, dt, middle) ? high : low) = middle;
  }
  return high;
}

double bound_of_step_over_limit(const std::vector<Vector2> &x, const std::vector<double> &mass, const SpringSet &springs, double dt)
{
  std::vector<double> sums(springs.held_points(), 0.0);
  for_each_spring(springs, [&](int a, int b, const Spring &spring) {
    const double strongest = std::max(spring.stiffness + 2.0 * spring.dashpot / dt, std::abs(sideways_stiffness(x[a] - x[b], spring)));
    sums[a] += 2.0 * strongest;
    sums[b] += 2.0 * strongest;
  });
  double largest = 0.0;
  for (std::size_t i = 0; i < sums.size(); ++i) largest = std::max(largest, sums[i] / mass[i]);
  return 0.5 * dt * std::sqrt(largest);
}

}  // namespace swellflow
