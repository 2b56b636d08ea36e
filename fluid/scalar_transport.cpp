#include "fluid/scalar_transport.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

#include "fluid/advection.h"

namespace swellflow {

namespace {

constexpr int most_sub_steps = 10000;  // with more the flow is not worth following

}  // namespace

template <int Dim>
ScalarTransport<Dim>::ScalarTransport(const Grid<Dim> &grid, const Layout<Dim> &layout, double diffusivity, const Sides &sides)
    : grid_(grid), layout_(layout), halo_(grid, layout), rows_(grid, layout), diffusivity_(diffusivity), sides_(sides), c_(layout), change_(layout), carrier_(layout)
{
}

template <int Dim> template <class F> void ScalarTransport<Dim>::each_row(F &&f) const
{
  for (int k = 0; k < layout_.planes(); ++k)
    for (int r = 0; r < layout_.rows(); ++r) f(layout_.row(k, r));
}

// ---- the step --------------------------------------------------------------------------------------------------------------------------------

template <int Dim> void ScalarTransport<Dim>::advance(double dt, const VectorField<Dim> &faces, bool grows)
{
  const double z = diffusivity_ * dt / (grid_.h * grid_.h), zw = z * stencil_weight();
  const double before = zw > 2.0 ? z / zw : 0.5 * z;
  take_mean_of_faces(faces);
  if (z > 0.0) diffuse_explicitly(before);
  if (grows) advect<true>(dt);
  else advect<false>(dt);
  if (zw > 1.0) diffuse_implicitly(z - before);
  else if (z > 0.0) diffuse_by_series(z - before);
  for (int d = 0; d < Dim; ++d) std::copy_n(faces[d].data(), layout_.size(), carrier_[d].data());
  knows_faces_before_ = true;
}

/// Neither of the two diverges, so their mean does not. Before the first step there is none that the fluid has passed: what it begins with need not obey its sides.
template <int Dim> void ScalarTransport<Dim>::take_mean_of_faces(const VectorField<Dim> &faces)
{
  for (int d = 0; d < Dim; ++d) {
    double *carrier = carrier_[d].data();
    const double *now = faces[d].data();
    if (knows_faces_before_)
      for (std::size_t i = 0; i < layout_.size(); ++i) carrier[i] = 0.5 * (carrier[i] + now[i]);
    else
      std::copy_n(now, layout_.size(), carrier);
  }
}

// ---- advection -------------------------------------------------------------------------------------------------------------------------------

template <int Dim> int ScalarTransport<Dim>::sub_steps_for(double dt) const
{
  double largest = 0.0;
  each_row([&](std::ptrdiff_t o) {
    for (int i = 0; i < layout_.row_length(); ++i) {
      double sum = 0.0;
      for (int d = 0; d < Dim; ++d) sum += std::abs(carrier_[d][o + i]) + std::abs(carrier_[d][o + i + layout_.stride(d)]);
      largest = std::max(largest, sum);
    }
  });
  MPI_Allreduce(MPI_IN_PLACE, &largest, 1, MPI_DOUBLE, MPI_MAX, grid_.comm);
  const double wanted = std::ceil(largest * dt / grid_.h);
  if (!(wanted <= most_sub_steps)) {
    std::ostringstream problem;
    problem << "a scalar must follow its fluid in at most " << most_sub_steps << " sub-steps of a fluid step, but would take " << wanted
            << ": use a smaller 'timestep' or 'every', or 'cfl 0.5'";
    throw std::runtime_error(problem.str());
  }
  return std::max(1, static_cast<int>(wanted));
}

/// Heun's method as a mean of states (Shu & Osher, J. Comput. Phys. 77, 1988): c1 = c + dt H(c), c <- (c + c1 + dt H(c1)) / 2.
template <int Dim> template <bool grows> void ScalarTransport<Dim>::advect(double dt)
{
  sub_steps_ = sub_steps_for(dt);
  const double step = dt / sub_steps_;
  for (int s = 0; s < sub_steps_; ++s) {
    fill_carried_ghosts(c_);
    count_carried(c_, 0.5 * step);
    each_row([&](std::ptrdiff_t o) { carry_row<grows, false>(c_.data() + o, change_.data() + o, o, step); });
    fill_carried_ghosts(change_);
    count_carried(change_, 0.5 * step);
    each_row([&](std::ptrdiff_t o) { carry_row<grows, true>(change_.data() + o, c_.data() + o, o, step); });
  }
}

/// to <- from + step H(from), or in the last stage to <- (to + from + step H(from)) / 2.
template <int Dim> template <bool grows, bool last> void ScalarTransport<Dim>::carry_row(const double *from, double *to, std::ptrdiff_t o, double step)
{
  const double per_flux = 0.5 * step / grid_.h;
  std::array<std::ptrdiff_t, Dim> s;
  std::array<const double *, Dim> face;
  for (int d = 0; d < Dim; ++d) {
    s[d] = layout_.stride(d);
    face[d] = carrier_[d].data() + o;
  }
  const int n = layout_.row_length();
  double appeared = 0.0;
#pragma GCC ivdep
  for (int i = 0; i < n; ++i) {
    const double *q = from + i;
    double leaving = 0.0, divergence = 0.0;
    for (int d = 0; d < Dim; ++d) {
      const double lower = face[d][i], upper = face[d][i + s[d]];
      leaving += upper * twice_on_face<Advection::bounded>(q, s[d], upper) - lower * twice_on_face<Advection::bounded>(q - s[d], s[d], lower);
      if constexpr (grows) divergence += upper - lower;
    }
    if constexpr (grows) {
      leaving -= 2.0 * divergence * q[0];
      appeared += divergence * q[0];
    }
    const double carried = q[0] - per_flux * leaving;
    to[i] = last ? 0.5 * (to[i] + carried) : carried;
  }
  if constexpr (grows) budget_.appeared += 0.5 * step / grid_.h * grid_.cell_volume() * appeared;
}

/// Where the flow comes in with a value given, all ghosts have it, so that it is the value on the side; else they continue the cell.
template <int Dim> void ScalarTransport<Dim>::fill_carried_ghosts(Field<Dim> &field)
{
  halo_.wrap(field, 2);
  halo_.fill(field, 2);
  for (int side = 0; side < 2 * Dim; ++side) {
    if (!ends_at(side)) continue;
    const std::ptrdiff_t out = rows_.outwards(side);
    const double inwards = side % 2 ? -1.0 : 1.0;
    rows_.each(side, [&](std::size_t, std::ptrdiff_t cell, int n) {
      double *inner = field.data() + cell;
      const double *face = carrier_[side / 2].data() + cell + rows_.face(side);
      for (int i = 0; i < n; ++i) {
        const bool given = sides_[side] != ScalarSide::open && inwards * face[i] > 0.0;
        inner[i + out] = inner[i + 2 * out] = given ? side_value_[side] : inner[i];
      }
    });
  }
}

/// What flows through the sides in a time of dt.
template <int Dim> void ScalarTransport<Dim>::count_carried(const Field<Dim> &field, double dt)
{
  const double per_flux = 0.5 * dt * grid_.cell_volume() / grid_.h;
  for (int side = 0; side < 2 * Dim; ++side) {
    if (!ends_at(side)) continue;
    const std::ptrdiff_t s = layout_.stride(side / 2), below = side % 2 ? 0 : -s;
    const double outwards = side % 2 ? 1.0 : -1.0;
    rows_.each(side, [&](std::size_t, std::ptrdiff_t cell, int n) {
      const double *face = carrier_[side / 2].data() + cell + rows_.face(side);
      for (int i = 0; i < n; ++i) {
        const double amount = per_flux * face[i] * twice_on_face<Advection::bounded>(field.data() + cell + below + i, s, face[i]);
        if (outwards * face[i] > 0.0) budget_.left += outwards * amount;
        else budget_.entered -= outwards * amount;
      }
    });
  }
}

// ---- what others see and take ----------------------------------------------------------------------------------------------------------------

template <int Dim> const Field<Dim> &ScalarTransport<Dim>::values_around()
{
  halo_.wrap(c_, Grid<Dim>::ghost);
  halo_.fill(c_, Grid<Dim>::ghost);
  return c_;
}

template <int Dim> Field<Dim> &ScalarTransport<Dim>::withdrawal()
{
  std::fill_n(change_.data(), layout_.size(), 0.0);
  return change_;
}

template <int Dim> void ScalarTransport<Dim>::withdraw()
{
  halo_.add(change_);
  double sum = 0.0;
  for (int k = 0; k < layout_.planes(); ++k) {
    halo_.fold(change_, k);
    for (int r = 0; r < layout_.rows(); ++r) {
      const std::ptrdiff_t o = layout_.row(k, r);
      for (int i = 0; i < layout_.row_length(); ++i) {
        const double share = change_[o + i];
        c_[o + i] /= 1.0 + share;
        sum += share * c_[o + i];
      }
    }
  }
  budget_.withdrawn += grid_.cell_volume() * sum;
}

template <int Dim> double ScalarTransport<Dim>::total_here() const
{
  double sum = 0.0;
  each_row([&](std::ptrdiff_t o) {
    double row = 0.0;
    for (int i = 0; i < layout_.row_length(); ++i) row += c_[o + i];
    sum += row;
  });
  return grid_.cell_volume() * sum;
}

template <int Dim> typename ScalarTransport<Dim>::Extremes ScalarTransport<Dim>::extremes_here() const
{
  Extremes found{HUGE_VAL, -HUGE_VAL};
  each_row([&](std::ptrdiff_t o) {
    const auto [smallest, largest] = std::minmax_element(c_.data() + o, c_.data() + o + layout_.row_length());
    found = {std::min(found.smallest, *smallest), std::max(found.largest, *largest)};
  });
  return found;
}

template class ScalarTransport<2>;

}  // namespace swellflow
