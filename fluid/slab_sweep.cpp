#include "fluid/slab_sweep.h"

#include <algorithm>
#include <numeric>

namespace swellflow {

SlabSweep::SlabSweep(MPI_Comm comm, int modes, int planes, bool mode_0_singular)
    : comm_(comm), modes_(modes), planes_(planes), mode_0_singular_(mode_0_singular)
{
  MPI_Comm_rank(comm, &rank_);
  MPI_Comm_size(comm, &ranks_);
  const int middle = (ranks_ + 1) / 2;
  upward_ = rank_ < middle;
  const int inner = upward_ ? rank_ + 1 : rank_ - 1, outer = upward_ ? rank_ - 1 : rank_ + 1;
  if (inner < ranks_) inner_ = inner;
  if (outer >= 0 && outer < ranks_) outer_ = outer;
  meets_ = has_inner() && (upward_ ? inner == middle : inner == middle - 1);

  const std::size_t n = modes;
  inverse_.resize(n * planes);
  if (has_outer()) response_.resize(n * (planes + 1));
  for (auto *row : {&next_, &y_first_, &y_last_, &a_, &b_, &f_, &g_, &q_, &a_here_, &b_here_, &b_partner_, &x_outer_, &x_first_})
    row->assign(n, 0.0);
  if (mode_0_singular_) {
    line_.resize(planes);
    line_counts_.resize(ranks_);
    MPI_Allgather(&planes_, 1, MPI_INT, line_counts_.data(), 1, MPI_INT, comm_);
    line_starts_.assign(ranks_, 0);
    std::partial_sum(line_counts_.begin(), line_counts_.end() - 1, line_starts_.begin() + 1);
    whole_line_.resize(line_starts_.back() + line_counts_.back());
  }
}

void SlabSweep::factor(double off_diagonal, double scale, const std::function<double(int, int)> &diagonal)
{
  e_ = off_diagonal;
  scale_ = scale;
  for (int s = 0; s < planes_; ++s) {
    double *v = &inverse_[static_cast<std::size_t>(s) * modes_];
    const double *v_before = v - modes_;
    for (int m = 0; m < modes_; ++m)
      v[m] = 1.0 / (diagonal(plane(s), m) - (s ? e_ * e_ * v_before[m] : 0.0));
    if (mode_0_singular_) v[0] = 0.0;
  }
  if (has_outer()) {
    std::fill_n(response_.begin(), modes_, 1.0);
    for (std::size_t i = 0; i < inverse_.size(); ++i) response_[i + modes_] = -e_ * inverse_[i] * response_[i];
  }
  if (ranks_ > 1) factor_borders();
}

void SlabSweep::factor_borders()
{
  const double *v_last = &inverse_[static_cast<std::size_t>(planes_ - 1) * modes_];
  if (has_outer()) {
    MPI_Recv(b_.data(), modes_, MPI_DOUBLE, outer_, 1, comm_, MPI_STATUS_IGNORE);
    std::fill(f_.begin(), f_.end(), 0.0);
    for (int s = 0; s < planes_; ++s) {
      const double *pi = &response_[static_cast<std::size_t>(s) * modes_];
      for (int m = 0; m < modes_; ++m) f_[m] += pi[m] * pi[m + modes_];
    }
    const double *pi_end = &response_[static_cast<std::size_t>(planes_) * modes_];
    for (int m = 0; m < modes_; ++m) {
      g_[m] = pi_end[m];
      q_[m] = pi_end[m] * b_[m] / (1.0 + f_[m] * b_[m]);
    }
  }
  // Without an outer neighbour g = q = 0.
  for (int m = 0; m < modes_; ++m) b_here_[m] = e_ * v_last[m] + q_[m] * g_[m];
  if (meets_)
    MPI_Sendrecv(b_here_.data(), modes_, MPI_DOUBLE, inner_, 1, b_partner_.data(), modes_, MPI_DOUBLE, inner_, 1, comm_, MPI_STATUS_IGNORE);
  else
    MPI_Send(b_here_.data(), modes_, MPI_DOUBLE, inner_, 1, comm_);
}

void SlabSweep::eliminate(int s, int first, int n, double *__restrict x, const double *__restrict before)
{
  const double *__restrict v = &inverse_[static_cast<std::size_t>(s) * modes_ + first];
  const double e = e_, scale = scale_;
  if (mode_0_singular_ && first == 0) line_[plane(s)] = scale * x[0];
  if (s == 0)
    for (int i = 0; i < n; ++i) x[i] = scale * x[i] * v[i];
  else
    for (int i = 0; i < n; ++i) x[i] = (scale * x[i] - e * before[i]) * v[i];

  if (has_outer()) {
    const double *__restrict pi = &response_[static_cast<std::size_t>(s) * modes_ + first];
    double *__restrict y = &y_first_[first];
    if (s == 0)
      std::copy_n(x, n, y);
    else
      for (int i = 0; i < n; ++i) y[i] += pi[i] * x[i];
  }
  if (s == planes_ - 1 && has_inner()) std::copy_n(x, n, &y_last_[first]);
}

void SlabSweep::meet()
{
  if (mode_0_singular_) solve_mode_0();
  if (ranks_ == 1) return;

  if (has_outer()) MPI_Recv(a_.data(), modes_, MPI_DOUBLE, outer_, 2, comm_, MPI_STATUS_IGNORE);
  for (int m = 0; m < modes_; ++m)
    a_here_[m] = y_last_[m] + g_[m] * a_[m] - q_[m] * (y_first_[m] + f_[m] * a_[m]);

  double *x_inner = next_.data();
  if (meets_) {
    MPI_Sendrecv(a_here_.data(), modes_, MPI_DOUBLE, inner_, 2, x_inner, modes_, MPI_DOUBLE, inner_, 2, comm_, MPI_STATUS_IGNORE);
    // x_I = A'' - B'' x_L and x_L = A' - B' x_I
    for (int m = 0; m < modes_; ++m)
      x_inner[m] = (x_inner[m] - b_partner_[m] * a_here_[m]) / (1.0 - b_partner_[m] * b_here_[m]);
  } else {
    MPI_Send(a_here_.data(), modes_, MPI_DOUBLE, inner_, 2, comm_);
    MPI_Recv(x_inner, modes_, MPI_DOUBLE, inner_, 3, comm_, MPI_STATUS_IGNORE);
  }
  if (has_outer()) {
    for (int m = 0; m < modes_; ++m) {
      x_first_[m] = (y_first_[m] + f_[m] * a_[m] + g_[m] * x_inner[m]) / (1.0 + f_[m] * b_[m]);
      x_outer_[m] = a_[m] - b_[m] * x_first_[m];
    }
    MPI_Send(x_first_.data(), modes_, MPI_DOUBLE, outer_, 3, comm_);
  }
}

void SlabSweep::substitute(int s, int first, int n, double *__restrict x)
{
  const double *__restrict v = &inverse_[static_cast<std::size_t>(s) * modes_ + first];
  double *__restrict next = &next_[first];
  const double e = e_;
  if (s < planes_ - 1 || has_inner())
    for (int i = 0; i < n; ++i) x[i] -= e * v[i] * next[i];
  if (has_outer()) {
    const double *__restrict pi = &response_[static_cast<std::size_t>(s + 1) * modes_ + first];
    const double *__restrict x_outer = &x_outer_[first];
    for (int i = 0; i < n; ++i) x[i] += pi[i] * x_outer[i];
  }
  if (mode_0_singular_ && first == 0) x[0] = line_[plane(s)];
  std::copy_n(x, n, next);
}

// e (x[k-1] - 2 x[k] + x[k+1]) = b[k] - mean(b) with zero gradient at both ends: one prefix sum gives the gradient, a second one x.
// Every rank does the whole line: it is one number a plane.
void SlabSweep::solve_mode_0()
{
  if (ranks_ == 1)
    std::copy(line_.begin(), line_.end(), whole_line_.begin());
  else
    MPI_Allgatherv(line_.data(), planes_, MPI_DOUBLE, whole_line_.data(), line_counts_.data(), line_starts_.data(), MPI_DOUBLE, comm_);
  const double count = static_cast<double>(whole_line_.size());
  const double mean_b = std::accumulate(whole_line_.begin(), whole_line_.end(), 0.0) / count;
  double gradient = 0.0, x = 0.0, sum = 0.0;
  for (double &value : whole_line_) {
    gradient += (value - mean_b) / e_;
    value = x;
    sum += x;
    x += gradient;
  }
  for (int k = 0; k < planes_; ++k) line_[k] = whole_line_[line_starts_[rank_] + k] - sum / count;
}

}  // namespace swellflow
