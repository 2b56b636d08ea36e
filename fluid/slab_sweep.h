// Tridiagonal systems, one a mode, along a direction that is cut into one piece a rank.
#pragma once

#include <mpi.h>

#include <functional>
#include <vector>

namespace swellflow {

/// For each mode m solves, over all planes k of all ranks,
///     e x[k-1] + d[k](m) x[k] + e x[k+1] = b[k]     (no x outside the first and last plane)
/// by Gaussian elimination from both ends of the whole column towards the rank border in its middle: lower ranks sweep upwards, upper ranks
/// downwards, so two ranks do the work of one and no more. A rank with a neighbour on its outer side does not wait for it: it eliminates as
/// if that neighbour's value x_O were zero, keeps the response pi to it (pi[s+1] = -e v[s] pi[s]), and the borders are then solved exactly by a
/// chain of messages of one plane between neighbours (no mode is truncated: low modes do not decay). The systems must be
/// regular, but for mode 0 when `mode_0_singular`: then d = -e at both ends and -2e elsewhere, the mean is taken out of b and out of x.
class SlabSweep {
public:
  SlabSweep(MPI_Comm comm, int modes, int planes, bool mode_0_singular);

  /// Factors the systems: diagonal(k, m) with k counted on this rank; every value of b is multiplied by `scale`. Collective.
  void factor(double off_diagonal, double scale, const std::function<double(int, int)> &diagonal);

  /// The plane at step s of this rank's sweep, s = 0 … planes - 1.
  int plane(int s) const { return upward_ ? s : planes_ - 1 - s; }
  /// Distance in planes from one step's plane to the next.
  int direction() const { return upward_ ? 1 : -1; }

  /// b -> eliminated values, for the modes first … first + n - 1; `before` holds those of the step before (unused at s = 0).
  void eliminate(int s, int first, int n, double *__restrict x, const double *__restrict before);
  /// Solves the borders between ranks. Collective.
  void meet();
  /// Eliminated values -> solution, for s = planes - 1 … 0.
  void substitute(int s, int first, int n, double *__restrict x);

private:
  void factor_borders();
  void solve_mode_0();
  bool has_outer() const { return outer_ != MPI_PROC_NULL; }
  bool has_inner() const { return inner_ != MPI_PROC_NULL; }

  MPI_Comm comm_;
  int ranks_ = 1, rank_ = 0;
  int modes_, planes_;
  bool upward_ = true, meets_ = false, mode_0_singular_;
  int outer_ = MPI_PROC_NULL, inner_ = MPI_PROC_NULL;
  double e_ = 0.0, scale_ = 1.0;
  std::vector<double> inverse_;   // v[s](m) = 1 / (d - e^2 v[s-1])
  std::vector<double> response_;  // pi[s](m), s = 0 … planes; only with an outer neighbour
  std::vector<double> next_;      // solution at the step after, while substituting; at first that of the inner neighbour
  // Borders, a value a mode. x_O = A - B x_F (outer neighbour), x_F = (y_F + f A + g x_I) / (1 + f B), x_L = A' - B' x_I.
  std::vector<double> y_first_, y_last_, a_, b_, f_, g_, q_, a_here_, b_here_, b_partner_, x_outer_, x_first_;
  std::vector<double> line_, whole_line_;  // mode 0
  std::vector<int> line_counts_, line_starts_;
};

}  // namespace swellflow
