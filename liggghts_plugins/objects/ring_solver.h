// Direct solution of the linear systems of a ring of points with or without a hub; free of LIGGGHTS.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "vector2.h"

namespace swellflow {

using Matrix2 = Eigen::Matrix2d;

/// A symmetric positive definite system A d = r with a 2 x 2 block for each point, for each pair of ring neighbours, and for each point and the hub: block Gaussian
/// elimination round the ring. What it fills in is a column for the last ring point and one for the hub, so the work is linear in the number of points.
class RingSolver {
public:
  /// All blocks are zero then.
  void start(int n_ring, bool with_hub);
  Matrix2 &diagonal(int point) { return diagonal_[point]; }   ///< point n_ring is the hub
  /// Block (a, b); b is the ring point that follows a, or the hub.
  Matrix2 &coupling(int a, int b) { return b == n_ ? to_hub_[a] : to_next_[a]; }
  Vector2 &right_side(int point) { return solution_[point]; }

  /// False when the matrix is not positive definite; the blocks are spent in any case.
  bool solve();
  const Vector2 &solution(int point) const { return solution_[point]; }

private:
  bool eliminate(int k);
  bool eliminate_last();
  void substitute_back();

  int n_ = 0;
  bool hub_ = false;
  std::vector<Matrix2> diagonal_, to_next_, to_last_, to_hub_, inverse_;
  std::vector<Vector2> solution_;
};

}  // namespace swellflow
