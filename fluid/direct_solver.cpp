#include "fluid/direct_solver.h"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace swellflow {

namespace {

fftw_r2r_kind kind_of(const Ends &ends, bool to_modes)
{
  if (ends.periodic()) return to_modes ? FFTW_R2HC : FFTW_HC2R;
  if (!ends.alike()) return ends.lower == End::value ? FFTW_RODFT11 : FFTW_REDFT11;
  if (ends.lower == End::value) return to_modes ? FFTW_RODFT10 : FFTW_RODFT01;
  return to_modes ? FFTW_REDFT10 : FFTW_REDFT01;
}

double shift(End end) { return end == End::value ? 1.0 : -1.0; }

}  // namespace

template <int Dim>
DirectSolver<Dim>::DirectSolver(const Grid<Dim> &grid, const Layout<Dim> &layout, const AllEnds<Dim> &ends)
    : grid_(grid), layout_(layout), ends_(ends), sweep_(grid.comm, layout.row_length() * layout.rows(), layout.planes())
{
  if (Dim == 3) {
    to_modes_across_ = plan_across_rows(true);
    to_cells_across_ = plan_across_rows(false);
  }
}

// All columns of a plane that cross its rows.
template <int Dim> typename DirectSolver<Dim>::Plan DirectSolver<Dim>::plan_across_rows(bool to_modes) const
{
  Field<Dim> scratch(layout_);
  double *plane = scratch.data() + layout_.row(0, 0);
  const fftw_iodim across = {layout_.rows(), static_cast<int>(layout_.stride(1)), static_cast<int>(layout_.stride(1))};
  const fftw_iodim along = {layout_.row_length(), 1, 1};
  const fftw_r2r_kind kind = kind_of(ends_[1], to_modes);
  Plan plan(fftw_plan_guru_r2r(1, &across, 1, &along, plane, plane, &kind, FFTW_ESTIMATE));
  if (!plan) throw std::runtime_error("FFTW made no plan for a plane of " + std::to_string(layout_.rows()) + " rows");
  return plan;
}

template <int Dim> void DirectSolver<Dim>::set_operator(double a, double c)
{
  const int n = layout_.row_length();
  double scale = 0.5 / n;
  std::vector<double> lambda(static_cast<std::size_t>(n) * layout_.rows());
  for (std::size_t m = 0; m < lambda.size(); ++m) lambda[m] = RowTransform::eigenvalue(ends_[0], n, static_cast<int>(m) % n);
  if constexpr (Dim == 3) {
    const int rows = layout_.rows();
    scale /= ends_[1].periodic() ? rows : 2.0 * rows;  // FFTW's gains
    // FFTW's sines are in the order of their waves.
    const bool sines = ends_[1].alike() && ends_[1].lower == End::value;
    for (std::size_t m = 0; m < lambda.size(); ++m) {
      const int r = static_cast<int>(m) / n;
      lambda[m] += RowTransform::eigenvalue(ends_[1], rows, sines ? rows - 1 - r : r);
    }
  }
  const Ends &last = ends_[Dim - 1];
  const bool has_value = std::any_of(ends_.begin(), ends_.end(), [](const Ends &e) { return e.lower == End::value || e.upper == End::value; });
  sweep_.factor({.off_diagonal = -c / (grid_.h * grid_.h),
                 .lower_shift = shift(last.lower),
                 .upper_shift = shift(last.upper),
                 .periodic = last.periodic(),
                 .mode_0_singular = a == 0.0 && !has_value},
                a, lambda, scale);
}

// ---- joint solves ----------------------------------------------------------------------------------------------------------------------------

template <int Dim, std::size_t N>
JointSolve<Dim, N>::JointSolve(const Layout<Dim> &layout, const std::array<std::shared_ptr<DirectSolver<Dim>>, N> &solvers)
    : layout_(layout), solvers_(solvers), transform_(layout.row_length())
{
  for (std::size_t c = 0; c < N; ++c) unknowns_[c] = solvers_[c]->sweep_.unknown();
}

template <int Dim, std::size_t N> template <class Transform>
void JointSolve<Dim, N>::two_by_two(const std::array<Field<Dim> *, N> &x, int s, int end, Transform &&transform)
{
  RowTransform::Row waiting{nullptr, {}};
  for (int t = s; t < end; ++t)
    for (int r = 0; r < layout_.rows(); ++r)
      for (std::size_t c = 0; c < N; ++c) {
        const RowTransform::Row row{x[c]->data() + layout_.row(plane(t), r), solvers_[c]->ends()[0]};
        if (waiting.values) {
          transform(waiting, row);
          waiting.values = nullptr;
        } else {
          waiting = row;
        }
      }
  if (waiting.values) transform(waiting, RowTransform::Row{nullptr, waiting.ends});
}

template <int Dim, std::size_t N> void JointSolve<Dim, N>::forward(const std::array<Field<Dim> *, N> &x, int s, int end)
{
  two_by_two(x, s, end, [this](const auto &a, const auto &b) { transform_.to_modes(a, b); });
  const int n = layout_.row_length();
  for (int t = s; t < end; ++t)
    for (std::size_t c = 0; c < N; ++c) {
      DirectSolver<Dim> &solver = *solvers_[c];
      const std::ptrdiff_t back = solver.sweep_.direction() * layout_.plane_stride();
      if constexpr (Dim == 3) {
        double *first = x[c]->data() + layout_.row(plane(t), 0);
        fftw_execute_r2r(solver.to_modes_across_.get(), first, first);
      }
      for (int r = 0; r < layout_.rows(); ++r) {
        double *row = x[c]->data() + layout_.row(plane(t), r);
        solver.sweep_.eliminate(unknowns_[c], t, r * n, n, row, row - back);
      }
    }
}

template <int Dim, std::size_t N> void JointSolve<Dim, N>::backward(const std::array<Field<Dim> *, N> &x, int s, int end)
{
  const int n = layout_.row_length();
  for (int t = end - 1; t >= s; --t)
    for (std::size_t c = 0; c < N; ++c) {
      DirectSolver<Dim> &solver = *solvers_[c];
      for (int r = 0; r < layout_.rows(); ++r)
        solver.sweep_.substitute(unknowns_[c], t, r * n, n, x[c]->data() + layout_.row(plane(t), r));
      if constexpr (Dim == 3) {
        double *first = x[c]->data() + layout_.row(plane(t), 0);
        fftw_execute_r2r(solver.to_cells_across_.get(), first, first);
      }
    }
  two_by_two(x, s, end, [this](const auto &a, const auto &b) { transform_.to_cells(a, b); });
}

template class DirectSolver<2>;
template class DirectSolver<3>;
template class JointSolve<2, 1>;
template class JointSolve<2, 2>;
template class JointSolve<3, 1>;
template class JointSolve<3, 3>;

}  // namespace swellflow
