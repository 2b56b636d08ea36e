#include "ring_solver.h"

namespace swellflow {

namespace {

/// False when a symmetric block is not positive definite.
bool invert(const Matrix2 &block, Matrix2 &inverse)
{
  const double a = block(0, 0), b = 0.5 * (block(0, 1) + block(1, 0)), c = block(1, 1), determinant = a * c - b * b;
  if (!(a > 0.0) || !(determinant > 0.0)) return false;
  const double scale = 1.0 / determinant;
  inverse << scale * c, -scale * b, -scale * b, scale * a;
  return true;
}

}  // namespace

void RingSolver::start(int n_ring, bool with_hub)
{
  n_ = n_ring;
  hub_ = with_hub;
  diagonal_.assign(n_ + 1, Matrix2::Zero());
  to_next_.assign(n_, Matrix2::Zero());
  to_hub_.assign(n_, Matrix2::Zero());
  to_last_.resize(n_);
  inverse_.resize(n_ + 1);
  solution_.assign(n_ + 1, Vector2::Zero());
}

bool RingSolver::solve()
{
  to_last_[0] = to_next_[n_ - 1].transpose();
  for (int k = 0; k < n_ - 1; ++k)
    if (!eliminate(k)) return false;
  if (!eliminate_last()) return false;
  substitute_back();
  return true;
}

/// Point k < n - 1 is coupled to its next, to the last point of the ring and to the hub; these become coupled to each other.
bool RingSolver::eliminate(int k)
{
  if (!invert(diagonal_[k], inverse_[k])) return false;
  const int last = n_ - 1;
  const Matrix2 &inverse = inverse_[k];
  const bool next_is_last = k + 1 == last;
  if (next_is_last) to_last_[k] += to_next_[k];
  const Matrix2 last_part = inverse * to_last_[k];
  const Vector2 r = inverse * solution_[k];
  diagonal_[last].noalias() -= to_last_[k].transpose() * last_part;
  solution_[last].noalias() -= to_last_[k].transpose() * r;
  if (!next_is_last) {
    const Matrix2 next_part = inverse * to_next_[k];
    diagonal_[k + 1].noalias() -= to_next_[k].transpose() * next_part;
    to_last_[k + 1].noalias() = -next_part.transpose() * to_last_[k];
    solution_[k + 1].noalias() -= to_next_[k].transpose() * r;
    if (hub_) to_hub_[k + 1].noalias() -= next_part.transpose() * to_hub_[k];
  }
  if (hub_) {
    const Matrix2 hub_part = inverse * to_hub_[k];
    to_hub_[last].noalias() -= last_part.transpose() * to_hub_[k];
    diagonal_[n_].noalias() -= to_hub_[k].transpose() * hub_part;
    solution_[n_].noalias() -= to_hub_[k].transpose() * r;
  }
  return true;
}

bool RingSolver::eliminate_last()
{
  const int last = n_ - 1;
  if (!invert(diagonal_[last], inverse_[last])) return false;
  if (!hub_) return true;
  diagonal_[n_].noalias() -= to_hub_[last].transpose() * inverse_[last] * to_hub_[last];
  solution_[n_].noalias() -= to_hub_[last].transpose() * (inverse_[last] * solution_[last]);
  return invert(diagonal_[n_], inverse_[n_]);
}

void RingSolver::substitute_back()
{
  const int last = n_ - 1;
  if (hub_) {
    solution_[n_] = inverse_[n_] * solution_[n_];
    solution_[last].noalias() -= to_hub_[last] * solution_[n_];
  }
  solution_[last] = inverse_[last] * solution_[last];
  for (int k = last - 1; k >= 0; --k) {
    Vector2 r = solution_[k] - to_last_[k] * solution_[last];
    if (k + 1 != last) r.noalias() -= to_next_[k] * solution_[k + 1];
    if (hub_) r.noalias() -= to_hub_[k] * solution_[n_];
    solution_[k] = inverse_[k] * r;
  }
}

}  // namespace swellflow
