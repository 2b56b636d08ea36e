// Diffusion of a scalar: the first part of a step, which is explicit, and the second, which is implicit or near to it.
#include <cmath>
#include <utility>

#include "fluid/scalar_transport.h"

namespace swellflow {

template <int Dim> AllEnds<Dim> ScalarTransport<Dim>::ends() const
{
  AllEnds<Dim> ends;
  const auto end = [&](int side) {
    if (!ends_at(side)) return End::periodic;
    return sides_[side] == ScalarSide::value ? End::value : End::gradient;
  };
  for (int d = 0; d < Dim; ++d) ends[d] = {end(2 * d), end(2 * d + 1)};
  return ends;
}

/// A side with a value is half as far away as a cell; a direction has at least two cells.
template <int Dim> double ScalarTransport<Dim>::stencil_weight() const
{
  double weight = 2.0 * Dim;
  for (int d = 0; d < Dim; ++d)
    if (sides_[2 * d] == ScalarSide::value || sides_[2 * d + 1] == ScalarSide::value) weight += 1.0;
  return weight;
}

/// c <- c + z h^2 L c
template <int Dim> void ScalarTransport<Dim>::diffuse_explicitly(double z)
{
  fill_diffusing_ghosts(c_);
  count_diffused(c_, z);
  for (int k = 0; k < layout_.planes(); ++k) difference_plane(k, z, c_, &c_, change_);
  std::swap(c_, change_);
}

/// The first terms of the inverse, 1 + y (1 + y) of 1 / (1 - y), y = z h^2 L: with the explicit part before it that is of second order, and makes no new extrema as long as 2 z w <= 1.
template <int Dim> void ScalarTransport<Dim>::diffuse_by_series(double z)
{
  fill_diffusing_ghosts(c_);
  for (int k = 0; k < layout_.planes(); ++k) difference_plane(k, z, c_, &c_, change_);
  fill_diffusing_ghosts(change_);
  count_diffused(change_, z);
  for (int k = 0; k < layout_.planes(); ++k) difference_plane(k, z, change_, &c_, c_);
}

/// (1 - z h^2 L) (new c - c) = z h^2 L c: for the difference, which the solution's round-off is relative to.
template <int Dim> void ScalarTransport<Dim>::diffuse_implicitly(double z)
{
  if (!solver_) {
    solver_ = std::make_shared<DirectSolver<Dim>>(grid_, layout_, ends());
    solve_.emplace(layout_, std::array{solver_});
  }
  if (z != z_factored_) solver_->set_operator(1.0, z * grid_.h * grid_.h);
  z_factored_ = z;
  fill_diffusing_ghosts(c_);
  (*solve_)({&change_}, [&](int k) { difference_plane(k, z, c_, nullptr, change_); }, [&](int k) { add_plane(k); });
  count_diffused(c_, z);
}

/// The value on a side is the mean of the cell and its ghost.
template <int Dim> void ScalarTransport<Dim>::fill_diffusing_ghosts(Field<Dim> &field)
{
  halo_.wrap(field, 1);
  halo_.fill(field, 1);
  for (int side = 0; side < 2 * Dim; ++side) {
    if (!ends_at(side)) continue;
    const std::ptrdiff_t out = rows_.outwards(side);
    const bool given = sides_[side] == ScalarSide::value;
    rows_.each(side, [&](std::size_t, std::ptrdiff_t cell, int n) {
      double *inner = field.data() + cell;
      for (int i = 0; i < n; ++i) inner[i + out] = given ? 2.0 * side_value_[side] - inner[i] : inner[i];
    });
  }
}

/// to <- onto + z h^2 L from; onto: none, or from, or to
template <int Dim> void ScalarTransport<Dim>::difference_plane(int k, double z, const Field<Dim> &from, const Field<Dim> *onto, Field<Dim> &to)
{
  const int n = layout_.row_length();
  std::array<std::ptrdiff_t, Dim> s;
  for (int d = 0; d < Dim; ++d) s[d] = layout_.stride(d);
  for (int r = 0; r < layout_.rows(); ++r) {
    const std::ptrdiff_t o = layout_.row(k, r);
    const double *c = from.data() + o, *base = onto ? onto->data() + o : nullptr;
    double *result = to.data() + o;
#pragma GCC ivdep
    for (int i = 0; i < n; ++i) {
      double sum = 0.0;
      for (int d = 0; d < Dim; ++d) sum += (c[i + s[d]] - c[i]) - (c[i] - c[i - s[d]]);
      result[i] = (base ? base[i] : 0.0) + z * sum;
    }
  }
}

template <int Dim> void ScalarTransport<Dim>::add_plane(int k)
{
  for (int r = 0; r < layout_.rows(); ++r) {
    const std::ptrdiff_t o = layout_.row(k, r);
    for (int i = 0; i < layout_.row_length(); ++i) c_[o + i] += change_[o + i];
  }
}

/// What comes and goes through sides with a value, where z h^2 L acts on the field.
template <int Dim> void ScalarTransport<Dim>::count_diffused(const Field<Dim> &field, double z)
{
  for (int side = 0; side < 2 * Dim; ++side) {
    if (sides_[side] != ScalarSide::value) continue;
    rows_.each(side, [&](std::size_t, std::ptrdiff_t cell, int n) {
      for (int i = 0; i < n; ++i) {
        const double inwards = 2.0 * z * grid_.cell_volume() * (side_value_[side] - field[cell + i]);
        (inwards > 0.0 ? budget_.entered : budget_.left) += std::abs(inwards);
      }
    });
  }
}

template AllEnds<2> ScalarTransport<2>::ends() const;
template double ScalarTransport<2>::stencil_weight() const;
template void ScalarTransport<2>::diffuse_explicitly(double);
template void ScalarTransport<2>::diffuse_by_series(double);
template void ScalarTransport<2>::diffuse_implicitly(double);
template void ScalarTransport<2>::fill_diffusing_ghosts(Field<2> &);
template void ScalarTransport<2>::difference_plane(int, double, const Field<2> &, const Field<2> *, Field<2> &);
template void ScalarTransport<2>::add_plane(int);
template void ScalarTransport<2>::count_diffused(const Field<2> &, double);

}  // namespace swellflow
