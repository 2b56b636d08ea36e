#include "fluid/slab_sweep.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace swellflow {

SlabSweep::SlabSweep(MPI_Comm comm, int modes, int planes) : comm_(comm), modes_(modes), planes_(planes)
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
  if (has_outer()) response_.resize(n * (planes + 1));
  for (auto *row : {&a_, &b_, &f_, &g_, &q_, &a_here_, &b_here_, &b_partner_, &x_first_}) row->assign(n, 0.0);
  line_counts_.resize(ranks_);
  MPI_Allgather(&planes_, 1, MPI_INT, line_counts_.data(), 1, MPI_INT, comm_);
  line_starts_.assign(ranks_, 0);
  std::partial_sum(line_counts_.begin(), line_counts_.end() - 1, line_starts_.begin() + 1);
  all_planes_ = line_starts_.back() + line_counts_.back();
}

SlabSweep::Unknown SlabSweep::unknown() const
{
  Unknown unknown;
  for (auto *row : {&unknown.next, &unknown.y_first, &unknown.y_last, &unknown.x_outer, &unknown.round}) row->assign(modes_, 0.0);
  unknown.line.resize(planes_);
  unknown.whole_line.resize(all_planes_);
  return unknown;
}

// ---- factors ---------------------------------------------------------------------------------------------------------------------------------

void SlabSweep::factor(const Column &column, double a, const std::vector<double> &lambda, double scale)
{
  column_ = column;
  scale_ = scale;
  std::vector<double> excess(modes_);  // of the diagonal over 2 (-e), in units of -e
  for (int m = 0; m < modes_; ++m) excess[m] = lambda[m] - a / column.off_diagonal;
  factor_planes(excess);
  if (ranks_ > 1) factor_borders();
  if (column.periodic) factor_round(excess);
}

/// v[s] from v[s-1], in place; at s = 0 from nothing.
void SlabSweep::next_plane(int s, const std::vector<double> &excess, std::vector<double> &plane_of_v) const
{
  const double lower = column_.periodic ? 1.0 : column_.lower_shift, upper = column_.periodic ? 1.0 : column_.upper_shift;
  const int k = line_starts_[rank_] + plane(s);
  const double shift = 2.0 + (k == 0 ? lower : 0.0) + (k == all_planes_ - 1 ? upper : 0.0), e = column_.off_diagonal;
  double *__restrict v = plane_of_v.data();
  const double *__restrict over = excess.data();
  for (int m = 0; m < modes_; ++m) v[m] = -1.0 / (e * (over[m] + shift + (s ? e * v[m] : 0.0)));
  if (column_.mode_0_singular) v[0] = 0.0;
}

// Twice through the planes: once to where they settle, which is before the last with its other diagonal, and once to store what differs.
void SlabSweep::factor_planes(const std::vector<double> &excess)
{
  v_.resize(modes_);
  for (int s = 0; s < std::max(1, planes_ - 1); ++s) next_plane(s, excess, v_);
  settled_ = v_;
  fresh_.clear();
  ranges_.clear();
  ranges_start_.assign(1, 0);
  if (has_outer()) std::fill_n(response_.begin(), modes_, 1.0);
  for (int s = 0; s < planes_; ++s) {
    next_plane(s, excess, v_);
    store_fresh(v_);
    if (!has_outer()) continue;
    const double *pi = &response_[static_cast<std::size_t>(s) * modes_];
    double *pi_next = &response_[static_cast<std::size_t>(s + 1) * modes_];
    for (int m = 0; m < modes_; ++m) pi_next[m] = -column_.off_diagonal * v_[m] * pi[m];
  }
  v_plane_ = planes_ - 1;
}

/// Ranges of modes that differ from the settled ones; a short gap between two costs less than a further range.
void SlabSweep::store_fresh(const std::vector<double> &plane_of_v)
{
  constexpr int gap = 16;
  int last = -gap;  // the mode that was stored last
  bool open = false;
  for (int m = 0; m < modes_; ++m) {
    if (plane_of_v[m] == settled_[m]) continue;
    if (!open || m - last > gap) {
      ranges_.push_back({m, 0, fresh_.size()});
      open = true;
    } else {
      for (int between = last + 1; between < m; ++between) fresh_.push_back(plane_of_v[between]);
    }
    fresh_.push_back(plane_of_v[m]);
    ranges_.back().count = m + 1 - ranges_.back().first;
    last = m;
  }
  ranges_start_.push_back(ranges_.size());
}

/// v_ becomes that of plane s.
void SlabSweep::bring_plane(int s)
{
  if (s == v_plane_) return;
  for (std::size_t i = ranges_start_[v_plane_]; i < ranges_start_[v_plane_ + 1]; ++i)
    std::copy_n(settled_.data() + ranges_[i].first, ranges_[i].count, v_.data() + ranges_[i].first);
  for (std::size_t i = ranges_start_[s]; i < ranges_start_[s + 1]; ++i)
    std::copy_n(fresh_.data() + ranges_[i].at, ranges_[i].count, v_.data() + ranges_[i].first);
  v_plane_ = s;
}

void SlabSweep::factor_borders()
{
  const double *v_last = v_.data();  // those of the last plane, just factored
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
  for (int m = 0; m < modes_; ++m) b_here_[m] = column_.off_diagonal * v_last[m] + q_[m] * g_[m];
  if (meets_)
    MPI_Sendrecv(b_here_.data(), modes_, MPI_DOUBLE, inner_, 1, b_partner_.data(), modes_, MPI_DOUBLE, inner_, 1, comm_, MPI_STATUS_IGNORE);
  else
    MPI_Send(b_here_.data(), modes_, MPI_DOUBLE, inner_, 1, comm_);
}

// w_k = cosh(t (k - (n-1)/2)) / { -e [ cosh(t (n+1)/2) + cosh(t (n-1)/2) ] }, divided through by the largest exponential.
void SlabSweep::factor_round(const std::vector<double> &excess)
{
  const double e = column_.off_diagonal, n = all_planes_;
  round_.resize(static_cast<std::size_t>(modes_) * planes_);
  round_factor_.resize(modes_);
  for (int m = 0; m < modes_; ++m) {
    const double t = 2.0 * std::asinh(0.5 * std::sqrt(excess[m]));
    const double below = 1.0 + std::exp(-t * (n + 1.0)) + std::exp(-t) + std::exp(-t * n);
    for (int s = 0; s < planes_; ++s) {
      const double k = line_starts_[rank_] + plane(s);
      round_[static_cast<std::size_t>(s) * modes_ + m] = (std::exp(-t * (n - k)) + std::exp(-t * (k + 1.0))) / (-e * below);
    }
    round_factor_[m] = e / (std::tanh(0.5 * t) * std::tanh(0.5 * n * t));
  }
  if (column_.mode_0_singular) round_factor_[0] = 0.0;
}

// ---- the solve -------------------------------------------------------------------------------------------------------------------------------

void SlabSweep::eliminate(Unknown &unknown, int s, int first, int n, double *__restrict x, const double *__restrict before)
{
  bring_plane(s);
  const std::size_t offset = static_cast<std::size_t>(s) * modes_ + first;
  const double *__restrict v = &v_[first];
  const double e = column_.off_diagonal, scale = scale_;
  if (column_.mode_0_singular && first == 0) unknown.line[plane(s)] = scale * x[0];
  if (column_.periodic) {
    const double *__restrict w = &round_[offset];
    double *__restrict round = &unknown.round[first];
    if (s == 0) std::fill_n(round, n, 0.0);
    for (int i = 0; i < n; ++i) round[i] += scale * w[i] * x[i];
  }
  if (s == 0)
    for (int i = 0; i < n; ++i) x[i] = scale * x[i] * v[i];
  else
    for (int i = 0; i < n; ++i) x[i] = (scale * x[i] - e * before[i]) * v[i];

  if (has_outer()) {
    const double *__restrict pi = &response_[offset];
    double *__restrict y = &unknown.y_first[first];
    if (s == 0)
      std::copy_n(x, n, y);
    else
      for (int i = 0; i < n; ++i) y[i] += pi[i] * x[i];
  }
  if (s == planes_ - 1 && has_inner()) std::copy_n(x, n, &unknown.y_last[first]);
}

void SlabSweep::meet(Unknown &unknown)
{
  if (column_.mode_0_singular) solve_mode_0(unknown);
  if (column_.periodic) {
    if (ranks_ > 1) MPI_Allreduce(MPI_IN_PLACE, unknown.round.data(), modes_, MPI_DOUBLE, MPI_SUM, comm_);
    for (int m = 0; m < modes_; ++m) unknown.round[m] *= round_factor_[m];
  }
  if (ranks_ == 1) return;

  if (has_outer()) MPI_Recv(a_.data(), modes_, MPI_DOUBLE, outer_, 2, comm_, MPI_STATUS_IGNORE);
  for (int m = 0; m < modes_; ++m)
    a_here_[m] = unknown.y_last[m] + g_[m] * a_[m] - q_[m] * (unknown.y_first[m] + f_[m] * a_[m]);

  double *x_inner = unknown.next.data();
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
      x_first_[m] = (unknown.y_first[m] + f_[m] * a_[m] + g_[m] * x_inner[m]) / (1.0 + f_[m] * b_[m]);
      unknown.x_outer[m] = a_[m] - b_[m] * x_first_[m];
    }
    MPI_Send(x_first_.data(), modes_, MPI_DOUBLE, outer_, 3, comm_);
  }
}

void SlabSweep::substitute(Unknown &unknown, int s, int first, int n, double *__restrict x)
{
  bring_plane(s);
  const std::size_t offset = static_cast<std::size_t>(s) * modes_ + first;
  const double *__restrict v = &v_[first];
  double *__restrict next = &unknown.next[first];
  const double e = column_.off_diagonal;
  if (s < planes_ - 1 || has_inner())
    for (int i = 0; i < n; ++i) x[i] -= e * v[i] * next[i];
  if (has_outer()) {
    const double *__restrict pi = &response_[offset + modes_];
    const double *__restrict x_outer = &unknown.x_outer[first];
    for (int i = 0; i < n; ++i) x[i] += pi[i] * x_outer[i];
  }
  if (column_.mode_0_singular && first == 0) x[0] = unknown.line[plane(s)];
  std::copy_n(x, n, next);
  if (column_.periodic) {
    const double *__restrict w = &round_[offset], *__restrict round = &unknown.round[first];
    for (int i = 0; i < n; ++i) x[i] -= w[i] * round[i];
  }
}

// e (x[k-1] - 2 x[k] + x[k+1]) = b[k] - mean(b): one prefix sum gives the gradient, a second one x. Zero gradient at both ends, or where periodic the
// first gradient that brings x back to where it began. Every rank does the whole line: it is one number a plane.
void SlabSweep::solve_mode_0(Unknown &unknown) const
{
  std::vector<double> &line = unknown.whole_line;
  if (ranks_ == 1)
    std::copy(unknown.line.begin(), unknown.line.end(), line.begin());
  else
    MPI_Allgatherv(unknown.line.data(), planes_, MPI_DOUBLE, line.data(), line_counts_.data(), line_starts_.data(), MPI_DOUBLE, comm_);
  const double count = static_cast<double>(line.size());
  const double mean_b = std::accumulate(line.begin(), line.end(), 0.0) / count;
  double gradient = 0.0, sum_of_gradients = 0.0;
  for (const double value : line) {
    gradient += (value - mean_b) / column_.off_diagonal;
    sum_of_gradients += gradient;
  }
  gradient = column_.periodic ? -sum_of_gradients / count : 0.0;
  double x = 0.0, sum = 0.0;
  for (double &value : line) {
    gradient += (value - mean_b) / column_.off_diagonal;
    value = x;
    sum += x;
    x += gradient;
  }
  for (int k = 0; k < planes_; ++k) unknown.line[k] = line[line_starts_[rank_] + k] - sum / count;
}

}  // namespace swellflow
