#include "fluid/flow_solver.h"

#include <cmath>

namespace swellflow {

namespace {

template <int Dim> std::array<End, Dim> all_ends(End end)
{
  std::array<End, Dim> ends;
  ends.fill(end);
  return ends;
}

}  // namespace

template <int Dim>
FlowSolver<Dim>::FlowSolver(const Grid<Dim> &grid, const FluidProperties &fluid, const WallVelocities<Dim> &walls)
    : grid_(grid), layout_(grid_), halo_(grid_, layout_), fluid_(fluid), walls_(walls), u_(layout_), u_star_(layout_), face_velocity_(layout_),
      advection_(layout_), p_(layout_), phi_(layout_), forcing_(grid_, layout_), viscous_(grid_, layout_, all_ends<Dim>(End::value)),
      poisson_(grid_, layout_, all_ends<Dim>(End::gradient))
{
  for (int side = 0; side < 2 * Dim; ++side)
    if (walls_[side][side / 2] != 0.0)
      throw std::invalid_argument("a wall must not move along its normal, but component " + std::to_string(side / 2) + " of its velocity is " +
                                  std::to_string(walls_[side][side / 2]) + "; give a velocity within the wall");
  poisson_.set_operator(0.0, -1.0);
}

template <int Dim> void FlowSolver<Dim>::start_from_velocity()
{
  fill_velocity_ghosts();
  dt_before_ = 0.0;
  each_face_row([&](int d, std::ptrdiff_t o, int i0, int i1) {
    const double *u = u_[d].data() + o;
    double *face = face_velocity_[d].data() + o;
    const std::ptrdiff_t s = layout_.stride(d);
    for (int i = i0; i < i1; ++i) face[i] = 0.5 * (u[i] + u[i - s]);
  });
}

// ---- ghosts ----------------------------------------------------------------------------------------------------------------------------------

// The wall's velocity is the mean of the cell and its ghost.
template <int Dim> void FlowSolver<Dim>::fill_velocity_ghosts()
{
  for (int c = 0; c < Dim; ++c) {
    Field<Dim> &u = u_[c];
    for (int d = 0; d < Dim - 1; ++d) {
      const std::ptrdiff_t s = layout_.stride(d), end = layout_.cells(d) * s;
      const double low = 2.0 * walls_[2 * d][c], high = 2.0 * walls_[2 * d + 1][c];
      const int n = d == 0 ? 1 : layout_.row_length(), rows = d == 0 ? layout_.rows() : 1;
      for (int k = 0; k < layout_.planes(); ++k)
        for (int r = 0; r < rows; ++r) {
          double *row = u.data() + layout_.row(k, r);
          for (int i = 0; i < n; ++i) {
            row[i - s] = low - row[i];
            row[i + end] = high - row[i + end - s];
          }
        }
    }
    const auto mirror = [&](int ghost, int inner, double twice_wall) {
      const double *from = u.data() + layout_.plane_begin(inner);
      double *to = u.data() + layout_.plane_begin(ghost);
      for (std::ptrdiff_t i = 0; i < layout_.plane_stride(); ++i) to[i] = twice_wall - from[i];
    };
    if (grid_.at_lower_end()) mirror(-1, 0, 2.0 * walls_[2 * Dim - 2][c]);
    if (grid_.at_upper_end()) mirror(layout_.planes(), layout_.planes() - 1, 2.0 * walls_[2 * Dim - 1][c]);
    halo_.fill(u, 1);
  }
}

template <int Dim> void FlowSolver<Dim>::fill_gradient_ghosts(Field<Dim> &field, int halo_width)
{
  for (int d = 0; d < Dim - 1; ++d) {
    const std::ptrdiff_t s = layout_.stride(d), end = layout_.cells(d) * s;
    const int n = d == 0 ? 1 : layout_.row_length(), rows = d == 0 ? layout_.rows() : 1;
    for (int k = 0; k < layout_.planes(); ++k)
      for (int r = 0; r < rows; ++r) {
        double *row = field.data() + layout_.row(k, r);
        for (int i = 0; i < n; ++i) {
          row[i - s] = row[i];
          row[i + end] = row[i + end - s];
        }
      }
  }
  const auto copy = [&](int ghost, int inner) {
    std::copy_n(field.data() + layout_.plane_begin(inner), layout_.plane_stride(), field.data() + layout_.plane_begin(ghost));
  };
  if (grid_.at_lower_end()) copy(-1, 0);
  if (grid_.at_upper_end()) copy(layout_.planes(), layout_.planes() - 1);
  halo_.fill(field, halo_width);
}

// ---- prediction ------------------------------------------------------------------------------------------------------------------------------

template <int Dim> void FlowSolver<Dim>::predict_velocity(double dt)
{
  dt_ = dt;
  const double nu_dt = fluid_.kinematic_viscosity * dt;
  alpha_ = 1.0 / (1.0 + 4.0 * nu_dt / (grid_.h * grid_.h));
  if (dt != dt_factored_) {
    viscous_.set_operator(1.0, 0.5 * nu_dt);
    dt_factored_ = dt;
  }
  fill_velocity_ghosts();
  fill_gradient_ghosts(p_, 2);
  viscous_.solve(u_star_[0], [&](int k) { predict_plane(k); }, [](int) {});
  for (int c = 1; c < Dim; ++c) viscous_.solve(u_star_[c], [](int) {}, [](int) {});
  for (int c = 0; c < Dim; ++c) halo_.fill(u_star_[c], 1);
  interpolate_to_faces();
}

// The right-hand sides of all components in plane k; H^n takes the place of H^(n-1).
template <int Dim> void FlowSolver<Dim>::predict_plane(int k)
{
  const double h = grid_.h, ratio = dt_before_ > 0.0 ? dt_ / dt_before_ : 0.0;
  const double now = -0.5 / h * dt_ * (1.0 + 0.5 * ratio), before = -0.5 / h * dt_ * 0.5 * ratio;
  const double gradient = 0.5 * dt_ / h, viscous = 0.5 * fluid_.kinematic_viscosity * dt_ / (h * h);
  const bool forced = forcing_.touches_neighbourhood(k);
  std::array<std::ptrdiff_t, Dim> s;
  for (int d = 0; d < Dim; ++d) s[d] = layout_.stride(d);

  for (int r = 0; r < layout_.rows(); ++r) {
    const std::ptrdiff_t o = layout_.row(k, r);
    std::array<const double *, Dim> u, face;
    std::array<double *, Dim> out, old;
    const double *p = p_.data() + o;
    for (int d = 0; d < Dim; ++d) {
      u[d] = u_[d].data() + o;
      face[d] = face_velocity_[d].data() + o;
      out[d] = u_star_[d].data() + o;
      old[d] = advection_[d].data() + o;
    }
    const int n = layout_.row_length();
#pragma GCC ivdep
    for (int i = 0; i < n; ++i) {
      for (int c = 0; c < Dim; ++c) {
        const double *q = u[c] + i;
        double flux = 0.0, laplacian = -2.0 * Dim * q[0];
        for (int d = 0; d < Dim; ++d) {
          flux += face[d][i + s[d]] * (q[0] + q[s[d]]) - face[d][i] * (q[0] + q[-s[d]]);
          laplacian += q[s[d]] + q[-s[d]];
        }
        out[c][i] = q[0] + now * flux - before * old[c][i] - gradient * (p[i + s[c]] - p[i - s[c]]) + viscous * laplacian;
        old[c][i] = flux;
      }
    }
    if (forced)
      for (int c = 0; c < Dim; ++c) {
        const double *f = forcing_.faces(c) + o;
        for (int i = 0; i < n; ++i) out[c][i] += 0.5 * (f[i] + f[i + s[c]]);
      }
  }
  for (int c = 0; c < Dim; ++c) add_wall_motion(c, k);
}

// The known ghost part, 2 u_wall, of the implicit half of viscosity.
template <int Dim> void FlowSolver<Dim>::add_wall_motion(int c, int k)
{
  const double factor = fluid_.kinematic_viscosity * dt_ / (grid_.h * grid_.h);
  const auto add = [&](int r, int i0, int i1, double wall) {
    double *row = u_star_[c].data() + layout_.row(k, r);
    for (int i = i0; i < i1; ++i) row[i] += factor * wall;
  };
  const int n = layout_.row_length(), rows = layout_.rows();
  for (int side = 0; side < 2 * Dim; ++side) {
    const double wall = walls_[side][c];
    if (wall == 0.0) continue;
    const int d = side / 2;
    const bool upper = side % 2;
    if (d == 0) {
      for (int r = 0; r < rows; ++r) add(r, upper ? n - 1 : 0, upper ? n : 1, wall);
    } else if (d == Dim - 1) {
      if (upper ? grid_.at_upper_end() && k == layout_.planes() - 1 : grid_.at_lower_end() && k == 0)
        for (int r = 0; r < rows; ++r) add(r, 0, n, wall);
    } else {
      add(upper ? rows - 1 : 0, 0, n, wall);
    }
  }
}

template <int Dim> template <class F> void FlowSolver<Dim>::each_face_row(F &&f) const
{
  const int n = layout_.row_length();
  for (int k = 0; k <= layout_.planes(); ++k) {
    const bool own = k < layout_.planes();
    for (int d = 0; d < Dim; ++d) {
      if (d == Dim - 1 ? (k == 0 && grid_.at_lower_end()) || (!own && grid_.at_upper_end()) : !own) continue;
      const int first_row = Dim == 3 && d == 1 ? 1 : 0;
      for (int r = first_row; r < layout_.rows(); ++r) f(d, layout_.row(k, r), d == 0 ? 1 : 0, n);
    }
  }
}

// Between two cells, mean of G p - (G p on the face) = (p[1] - 3 p[0] + 3 p[-1] - p[-2]) / 4h, and mean of f - f on the face = (f[1] - 2 f[0] + f[-1]) / 4.
template <int Dim> void FlowSolver<Dim>::interpolate_to_faces()
{
  const double pressure = 0.25 * alpha_ * dt_ / grid_.h, force = 0.25 * alpha_;
  const std::ptrdiff_t plane_stride = layout_.plane_stride();
  each_face_row([&](int d, std::ptrdiff_t o, int i0, int i1) {
    const std::ptrdiff_t s = layout_.stride(d);
    const double *u = u_star_[d].data() + o, *p = p_.data() + o;
    double *face = face_velocity_[d].data() + o;
#pragma GCC ivdep
    for (int i = i0; i < i1; ++i) face[i] = 0.5 * (u[i] + u[i - s]) + pressure * (p[i + s] - p[i - 2 * s] - 3.0 * (p[i] - p[i - s]));
    if (forcing_.touches_neighbourhood(static_cast<int>((o - layout_.row(0, 0)) / plane_stride))) {
      const double *f = forcing_.faces(d) + o;
      for (int i = i0; i < i1; ++i) face[i] += force * (2.0 * f[i] - f[i - s] - f[i + s]);
    }
  });
}

template <int Dim> void FlowSolver<Dim>::apply_forcing()
{
  for (int k = 0; k < layout_.planes(); ++k) {
    if (!forcing_.touches_neighbourhood(k)) continue;
    for (int r = 0; r < layout_.rows(); ++r)
      for (int c = 0; c < Dim; ++c) {
        const std::ptrdiff_t o = layout_.row(k, r), s = layout_.stride(c);
        const double *f = forcing_.faces(c) + o;
        double *u = u_star_[c].data() + o;
        for (int i = 0; i < layout_.row_length(); ++i) u[i] += 0.5 * (f[i] + f[i + s]);
      }
  }
  each_face_row([&](int d, std::ptrdiff_t o, int i0, int i1) {
    const double *f = forcing_.faces(d) + o;
    double *face = face_velocity_[d].data() + o;
    for (int i = i0; i < i1; ++i) face[i] += f[i];
  });
}

// ---- projection ------------------------------------------------------------------------------------------------------------------------------

template <int Dim> void FlowSolver<Dim>::divergence_plane(int k, double *out, double scale) const
{
  const int n = layout_.row_length();
  for (int r = 0; r < layout_.rows(); ++r) {
    const std::ptrdiff_t o = layout_.row(k, r);
    double *row = out + o;
    for (int d = 0; d < Dim; ++d) {
      const double *face = face_velocity_[d].data() + o;
      const std::ptrdiff_t s = layout_.stride(d);
#pragma GCC ivdep
      for (int i = 0; i < n; ++i) row[i] = (d ? row[i] : 0.0) + scale * (face[i + s] - face[i]);
    }
  }
}

template <int Dim> void FlowSolver<Dim>::project(double dt)
{
  poisson_.solve(phi_, [&](int k) { divergence_plane(k, phi_.data(), 1.0 / (grid_.h * dt)); }, [](int) {});
  fill_gradient_ghosts(phi_, 1);
  correct(dt);
  dt_before_ = dt;
}

template <int Dim> void FlowSolver<Dim>::correct(double dt)
{
  const double face_gradient = dt / grid_.h, cell_gradient = 0.5 * face_gradient;
  each_face_row([&](int d, std::ptrdiff_t o, int i0, int i1) {
    const double *phi = phi_.data() + o;
    double *face = face_velocity_[d].data() + o;
    const std::ptrdiff_t s = layout_.stride(d);
#pragma GCC ivdep
    for (int i = i0; i < i1; ++i) face[i] -= face_gradient * (phi[i] - phi[i - s]);
  });
  const int n = layout_.row_length();
  for (int k = 0; k < layout_.planes(); ++k)
    for (int r = 0; r < layout_.rows(); ++r) {
      const std::ptrdiff_t o = layout_.row(k, r);
      const double *phi = phi_.data() + o;
      double *p = p_.data() + o;
      for (int c = 0; c < Dim; ++c) {
        const double *from = u_star_[c].data() + o;
        double *u = u_[c].data() + o;
        const std::ptrdiff_t s = layout_.stride(c);
#pragma GCC ivdep
        for (int i = 0; i < n; ++i) u[i] = from[i] - cell_gradient * (phi[i + s] - phi[i - s]);
      }
#pragma GCC ivdep
      for (int i = 0; i < n; ++i) p[i] += phi[i];
    }
}

// ---- measures --------------------------------------------------------------------------------------------------------------------------------

template <int Dim> double FlowSolver<Dim>::largest_over_ranks(double value) const
{
  MPI_Allreduce(MPI_IN_PLACE, &value, 1, MPI_DOUBLE, MPI_MAX, grid_.comm);
  return value;
}

template <int Dim> template <class F> void FlowSolver<Dim>::each_cell(F &&f) const
{
  for (int k = 0; k < layout_.planes(); ++k)
    for (int r = 0; r < layout_.rows(); ++r)
      for (int i = 0; i < layout_.row_length(); ++i) f(layout_.row(k, r) + i);
}

template <int Dim> double FlowSolver<Dim>::largest_divergence_here() const
{
  double largest = 0.0;
  each_cell([&](std::ptrdiff_t cell) {
    double divergence = 0.0;
    for (int d = 0; d < Dim; ++d) divergence += face_velocity_[d][cell + layout_.stride(d)] - face_velocity_[d][cell];
    largest = std::max(largest, std::abs(divergence));
  });
  return largest / grid_.h;
}

template <int Dim> double FlowSolver<Dim>::max_speed_sum() const
{
  double largest = 0.0;
  each_cell([&](std::ptrdiff_t cell) {
    double sum = 0.0;
    for (int c = 0; c < Dim; ++c) sum += std::abs(u_[c][cell]);
    largest = std::max(largest, sum);
  });
  return largest_over_ranks(largest);
}

template <int Dim> double FlowSolver<Dim>::kinetic_energy() const
{
  double sum = 0.0;
  each_cell([&](std::ptrdiff_t cell) {
    for (int c = 0; c < Dim; ++c) sum += u_[c][cell] * u_[c][cell];
  });
  MPI_Allreduce(MPI_IN_PLACE, &sum, 1, MPI_DOUBLE, MPI_SUM, grid_.comm);
  return 0.5 * fluid_.density * grid_.cell_volume() * sum;
}

template class FlowSolver<2>;

}  // namespace swellflow
