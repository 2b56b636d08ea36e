#include "fluid/boundaries.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace swellflow {

namespace {

bool is_inflow(Boundary kind) { return kind == Boundary::inflow || kind == Boundary::parabolic_inflow; }

std::string name_of(int side) { return std::string(1, "xyz"[side / 2]) + (side % 2 ? "hi" : "lo"); }

}  // namespace

// ---- what can be solved ----------------------------------------------------------------------------------------------------------------------

template <int Dim> std::array<bool, Dim> Boundaries<Dim>::periodic() const
{
  std::array<bool, Dim> result;
  for (int d = 0; d < Dim; ++d) result[d] = kind[2 * d] == Boundary::periodic;
  return result;
}

template <int Dim> void Boundaries<Dim>::require_solvable() const
{
  bool has_inflow = false, has_outflow = false;
  for (int side = 0; side < 2 * Dim; ++side) {
    const int d = side / 2;
    const double normal = velocity[side][d];
    has_inflow = has_inflow || is_inflow(kind[side]);
    has_outflow = has_outflow || kind[side] == Boundary::outflow;
    if ((kind[2 * d] == Boundary::periodic) != (kind[2 * d + 1] == Boundary::periodic))
      throw std::invalid_argument("a periodic direction has two periodic sides, but only one of " + name_of(2 * d) + " and " + name_of(2 * d + 1) + " is");
    if (kind[side] == Boundary::wall && normal != 0.0)
      throw std::invalid_argument("a wall must not move along its normal, but at " + name_of(side) + " that component is " + std::to_string(normal) +
                                  "; give a velocity within the wall");
    if (is_inflow(kind[side]) && (side % 2 ? normal > 0.0 : normal < 0.0))
      throw std::invalid_argument("an inflow must point into the box, but at " + name_of(side) + " its normal velocity is " + std::to_string(normal) +
                                  "; change its sign, or make the side an outflow");
  }
  if (has_inflow && !has_outflow)
    throw std::invalid_argument("what flows in must be able to leave, but the box has an inflow and no outflow; make a side an outflow");
}

// ---- what is given where ---------------------------------------------------------------------------------------------------------------------

template <int Dim> bool BoundaryValues<Dim>::is_given(int side, int c) const
{
  return boundaries_.kind[side] == Boundary::slip ? c == side / 2 : true;
}

// ---- the velocity on the sides ---------------------------------------------------------------------------------------------------------------

template <int Dim>
BoundaryValues<Dim>::BoundaryValues(const Grid<Dim> &grid, const Layout<Dim> &layout, const Boundaries<Dim> &boundaries)
    : grid_(grid), layout_(layout), rows_(grid, layout), boundaries_(boundaries)
{
  boundaries_.require_solvable();
  for (int side = 0; side < 2 * Dim; ++side) {
    if (boundaries_.kind[side] == Boundary::outflow) {
      double area = 1.0;
      for (int d = 0; d < Dim; ++d)
        if (d != side / 2) area *= grid_.h * grid_.cells[d];
      outflow_area_ += area;
    }
    if (!is_here(side)) continue;
    std::size_t count = 0;
    each_row(side, [&](std::size_t, std::ptrdiff_t, int n) { count += n; });
    for (auto &values : next_[side]) values.assign(count, 0.0);
    set_given(side);
  }
  present_ = next_;
}

template <int Dim> void BoundaryValues<Dim>::set_velocity(int side, const Vec<Dim> &velocity)
{
  if (velocity == boundaries_.velocity[side]) return;
  boundaries_.velocity[side] = velocity;
  boundaries_.require_solvable();
}

/// 1, or for a parabolic inflow the product of 4 s (1 - s) over the directions along the side.
template <int Dim> double BoundaryValues<Dim>::profile(int side, std::size_t index) const
{
  if (boundaries_.kind[side] != Boundary::parabolic_inflow) return 1.0;
  double result = 1.0;
  for (int d = 0; d < Dim; ++d) {
    if (d == side / 2) continue;
    const int count = layout_.cells(d);
    const double first = d == Dim - 1 ? grid_.first_plane : 0.0;
    const double s = (first + static_cast<double>(index % count) + 0.5) / grid_.cells[d];
    index /= count;
    result *= 4.0 * s * (1.0 - s);
  }
  return result;
}

template <int Dim> void BoundaryValues<Dim>::set_given(int side)
{
  const Boundary kind = boundaries_.kind[side];
  if (kind != Boundary::wall && !is_inflow(kind)) return;
  for (int c = 0; c < Dim; ++c)
    for (std::size_t i = 0; i < next_[side][c].size(); ++i) next_[side][c][i] = boundaries_.velocity[side][c] * profile(side, i);
}

template <int Dim> void BoundaryValues<Dim>::start(const VectorField<Dim> &u)
{
  for (int side = 0; side < 2 * Dim; ++side) {
    if (boundaries_.kind[side] != Boundary::outflow) continue;
    for (int c = 0; c < Dim; ++c)
      each_row(side, [&](std::size_t i, std::ptrdiff_t cell, int n) { std::copy_n(u[c].data() + cell, n, next_[side][c].data() + i); });
  }
  present_ = next_;
}

template <int Dim> void BoundaryValues<Dim>::advance(double dt, const VectorField<Dim> &u)
{
  for (int side = 0; side < 2 * Dim; ++side)
    if (is_here(side)) set_given(side);
  if (has_outflow()) carry_out(dt, u);
}

/// Through all sides but outflows, and within the box. Collective.
template <int Dim> double BoundaryValues<Dim>::entering() const
{
  const double area = grid_.cell_volume() / grid_.h;
  double sum = 0.0;
  for (int side = 0; side < 2 * Dim; ++side) {
    if (!is_here(side) || boundaries_.kind[side] == Boundary::outflow) continue;
    for (const double v : next_[side][side / 2]) sum += (side % 2 ? -area : area) * v;
  }
  MPI_Allreduce(MPI_IN_PLACE, &sum, 1, MPI_DOUBLE, MPI_SUM, grid_.comm);
  return sum + source_;
}

// Upwind over half a cell, implicit in the value on the side: stable for any dt. Where fluid is drawn in, the side keeps its velocity, but for the balance.
template <int Dim> void BoundaryValues<Dim>::carry_out(double dt, const VectorField<Dim> &u)
{
  const double inflow = entering(), area = grid_.cell_volume() / grid_.h, courant = 2.0 * std::max(0.0, inflow / outflow_area_) * dt / grid_.h;
  double leaving = 0.0;
  for (int side = 0; side < 2 * Dim; ++side) {
    if (boundaries_.kind[side] != Boundary::outflow) continue;
    for (int c = 0; c < Dim; ++c)
      each_row(side, [&](std::size_t first, std::ptrdiff_t cell, int n) {
        for (int i = 0; i < n; ++i) {
          double &next = next_[side][c][first + i];
          next = (present_[side][c][first + i] + courant * u[c][cell + i]) / (1.0 + courant);
          if (c == side / 2) leaving += (side % 2 ? area : -area) * next;
        }
      });
  }
  MPI_Allreduce(MPI_IN_PLACE, &leaving, 1, MPI_DOUBLE, MPI_SUM, grid_.comm);
  shift_outflows((inflow - leaving) / outflow_area_);
}

template <int Dim> void BoundaryValues<Dim>::shift_outflows(double change)
{
  for (int side = 0; side < 2 * Dim; ++side)
    if (boundaries_.kind[side] == Boundary::outflow)
      for (double &normal : next_[side][side / 2]) normal += side % 2 ? change : -change;
}

template <int Dim> void BoundaryValues<Dim>::let_out(double source)
{
  shift_outflows((source - source_) / outflow_area_);
  source_ = source;
}

// ---- ghosts ----------------------------------------------------------------------------------------------------------------------------------

template <int Dim> AllEnds<Dim> BoundaryValues<Dim>::velocity_ends(int component) const
{
  AllEnds<Dim> ends;
  const auto end = [&](int side) {
    if (boundaries_.kind[side] == Boundary::periodic) return End::periodic;
    return is_given(side, component) ? End::value : End::gradient;
  };
  for (int d = 0; d < Dim; ++d) ends[d] = {end(2 * d), end(2 * d + 1)};
  return ends;
}

template <int Dim> AllEnds<Dim> BoundaryValues<Dim>::pressure_ends() const
{
  AllEnds<Dim> ends;
  for (int d = 0; d < Dim; ++d) {
    const End end = boundaries_.kind[2 * d] == Boundary::periodic ? End::periodic : End::gradient;
    ends[d] = {end, end};
  }
  return ends;
}

template <int Dim> void BoundaryValues<Dim>::fill_velocity(VectorField<Dim> &u, int width, const Halo<Dim> &halo) const
{
  for (int c = 0; c < Dim; ++c) {
    for (int side = 0; side < 2 * Dim; ++side) {
      const std::ptrdiff_t out = rows_.outwards(side);
      const bool given = is_given(side, c);
      each_row(side, [&](std::size_t first, std::ptrdiff_t cell, int n) {
        double *inner = u[c].data() + cell;
        const double *value = present_[side][c].data() + first;
        for (int i = 0; i < n; ++i) inner[i + out] = given ? 2.0 * value[i] - inner[i] : inner[i];
        if (width > 1)
          for (int i = 0; i < n; ++i) inner[i + 2 * out] = 2.0 * inner[i + out] - inner[i];
      });
    }
    halo.wrap(u[c], width);
    halo.fill(u[c], width);
  }
}

template <int Dim> void BoundaryValues<Dim>::fill_scalar_plane(Field<Dim> &field, int k, int width, const Halo<Dim> &halo) const
{
  for (int side = 0; side < 2 * (Dim - 1); ++side) {
    if (!is_here(side)) continue;
    const std::ptrdiff_t out = rows_.outwards(side);
    rows_.each_in_plane(side, k, [&](std::size_t, std::ptrdiff_t cell, int n) { std::copy_n(field.data() + cell, n, field.data() + cell + out); });
  }
  halo.wrap_plane(field, k, width);
}

template <int Dim> void BoundaryValues<Dim>::fill_scalar_ends(Field<Dim> &field, int width, const Halo<Dim> &halo) const
{
  for (int side = 2 * Dim - 2; side < 2 * Dim; ++side) {
    const std::ptrdiff_t out = rows_.outwards(side);
    each_row(side, [&](std::size_t, std::ptrdiff_t cell, int n) { std::copy_n(field.data() + cell, n, field.data() + cell + out); });
  }
  halo.fill(field, width);
}

template <int Dim> void BoundaryValues<Dim>::add_given(int c, int k, double factor, Field<Dim> &rhs) const
{
  for (int side = 0; side < 2 * Dim; ++side) {
    if (!is_here(side) || !is_given(side, c)) continue;
    rows_.each_in_plane(side, k, [&](std::size_t first, std::ptrdiff_t cell, int n) {
      for (int i = 0; i < n; ++i) rhs[cell + i] += factor * next_[side][c][first + i];
    });
  }
}

template <int Dim> void BoundaryValues<Dim>::set_faces(VectorField<Dim> &faces) const
{
  for (int side = 0; side < 2 * Dim; ++side) {
    const int d = side / 2;
    const std::ptrdiff_t face = rows_.face(side);
    each_row(side, [&](std::size_t first, std::ptrdiff_t cell, int n) { std::copy_n(next_[side][d].data() + first, n, faces[d].data() + cell + face); });
  }
}

template struct Boundaries<2>;
template class BoundaryValues<2>;

}  // namespace swellflow
