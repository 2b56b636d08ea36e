#include "fluid/direct_solver.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace swellflow {

template <int Dim>
DirectSolver<Dim>::DirectSolver(const Grid<Dim> &grid, const Layout<Dim> &layout, const std::array<End, Dim> &ends)
    : grid_(grid), layout_(layout), ends_(ends)
{
  Field<Dim> scratch(layout);
  double *buffer = scratch.data() + layout.row(0, 0);
  to_modes_ = plan(FFTW_RODFT10, FFTW_REDFT10, buffer);
  to_cells_ = plan(FFTW_RODFT01, FFTW_REDFT01, buffer);
}

template <int Dim>
typename DirectSolver<Dim>::Plan DirectSolver<Dim>::plan(fftw_r2r_kind for_value, fftw_r2r_kind for_gradient, double *buffer) const
{
  // FFTW counts dimensions from the slowest to the fastest.
  std::array<fftw_iodim, Dim - 1> dims;
  std::array<fftw_r2r_kind, Dim - 1> kinds;
  for (int d = 0; d < Dim - 1; ++d) {
    const int stride = static_cast<int>(layout_.stride(d));
    dims[Dim - 2 - d] = {layout_.cells(d), stride, stride};
    kinds[Dim - 2 - d] = ends_[d] == End::value ? for_value : for_gradient;
  }
  Plan result(fftw_plan_guru_r2r(Dim - 1, dims.data(), 0, nullptr, buffer, buffer, kinds.data(), FFTW_ESTIMATE));
  if (!result) throw std::runtime_error("FFTW made no plan for a plane of " + std::to_string(layout_.cells(0)) + " cells");
  return result;
}

template <int Dim> void DirectSolver<Dim>::set_operator(double a, double c)
{
  const bool singular = a == 0.0 && std::all_of(ends_.begin(), ends_.end(), [](End end) { return end == End::gradient; });
  const int row_length = layout_.row_length();
  const int modes = row_length * layout_.rows();
  if (!sweep_) sweep_ = std::make_unique<SlabSweep>(grid_.comm, modes, layout_.planes(), singular);

  // Eigenvalues of -L h^2 of the transforms; FFTW's pairs are not normalised.
  std::array<std::vector<double>, Dim> lambda;
  double scale = 1.0;
  for (int d = 0; d < Dim - 1; ++d) {
    const int n = layout_.cells(d), shift = ends_[d] == End::value ? 1 : 0;
    scale /= 2.0 * n;
    for (int i = 0; i < n; ++i) lambda[d].push_back(2.0 * (1.0 - std::cos(std::numbers::pi * (i + shift) / n)));
  }
  const double off = -c / (grid_.h * grid_.h);
  const double end_shift = ends_[Dim - 1] == End::value ? 1.0 : -1.0;
  sweep_->factor(off, scale, [&](int k, int m) {
    double sum = lambda[0][m % row_length] + 2.0;
    if constexpr (Dim == 3) sum += lambda[1][m / row_length];
    if (grid_.at_lower_end() && k == 0) sum += end_shift;
    if (grid_.at_upper_end() && k == layout_.planes() - 1) sum += end_shift;
    return a - off * sum;
  });
}

template <int Dim> void DirectSolver<Dim>::forward(int s, Field<Dim> &x)
{
  const int k = sweep_->plane(s), n = layout_.row_length();
  const std::ptrdiff_t back = sweep_->direction() * layout_.plane_stride();
  double *plane = x.data() + layout_.row(k, 0);
  fftw_execute_r2r(to_modes_.get(), plane, plane);
  for (int r = 0; r < layout_.rows(); ++r) {
    double *row = x.data() + layout_.row(k, r);
    sweep_->eliminate(s, r * n, n, row, row - back);
  }
}

template <int Dim> void DirectSolver<Dim>::backward(int s, Field<Dim> &x)
{
  const int k = sweep_->plane(s), n = layout_.row_length();
  for (int r = 0; r < layout_.rows(); ++r) sweep_->substitute(s, r * n, n, x.data() + layout_.row(k, r));
  double *plane = x.data() + layout_.row(k, 0);
  fftw_execute_r2r(to_cells_.get(), plane, plane);
}

template class DirectSolver<2>;
template class DirectSolver<3>;

}  // namespace swellflow
