// Tridiagonal systems, one a mode, along a direction that is cut into one piece a rank.
#pragma once

#include <mpi.h>

#include <vector>

namespace swellflow {

/// For each mode m solves, over all planes k of all ranks,
///     e x[k-1] + d(m) x[k] + e x[k+1] = b[k]
/// with x outside the first and last plane being zero, minus or plus the first or last x (a shift of d there), or those of the other end (periodic).
///
/// Gaussian elimination from both ends of the whole column towards the rank border in its middle: lower ranks sweep upwards, upper ranks
/// downwards, so two ranks do the work of one and no more. A rank with a neighbour on its outer side does not wait for it: it eliminates as
/// if that neighbour's value x_O were zero, keeps the response pi to it (pi[s+1] = -e v[s] pi[s]), and the borders are then solved exactly by a
/// chain of messages of one plane between neighbours (no mode is truncated: low modes do not decay).
///
/// Periodic columns: with A the matrix whose two ends have the value zero half a plane outside and s = (1, 0, … 0, 1), the periodic matrix is A + e s s^T
/// (Sherman & Morrison 1950): x = y - w e (w.b) / (1 + e s.w), A y = b, A w = s. With d = -2 e cosh(t) and n planes, 1 + e s.w = tanh(t/2) tanh(n t/2).
///
/// The systems must be regular, but for mode 0 when it is `mode_0_singular`: then the mean is taken out of b and out of x.
class SlabSweep {
public:
  struct Column {
    double off_diagonal = 0.0;                    ///< e, of either sign
    double lower_shift = 0.0, upper_shift = 0.0;  ///< added to d in the first and the last plane of all, in units of -e: -1 zero gradient, 1 zero value
    bool periodic = false;
    bool mode_0_singular = false;
  };
  /// What a solve keeps between its phases; several may be under way at once.
  struct Unknown {
    std::vector<double> next;             // solution at the step after, while substituting; at first that of the inner neighbour
    std::vector<double> y_first, y_last, x_outer;
    std::vector<double> round;            // periodic: w.b, then the factor of w
    std::vector<double> line, whole_line;  // mode 0
  };

  SlabSweep(MPI_Comm comm, int modes, int planes);
  Unknown unknown() const;

  /// Factors the systems, d(m) = a - e (2 + lambda(m)), lambda >= 0; every value of b is multiplied by `scale`. Collective.
  void factor(const Column &column, double a, const std::vector<double> &lambda, double scale);

  /// The plane at step s of this rank's sweep, s = 0 … planes - 1.
  int plane(int s) const { return upward_ ? s : planes_ - 1 - s; }
  /// Distance in planes from one step's plane to the next.
  int direction() const { return upward_ ? 1 : -1; }

  /// b -> eliminated values, for the modes first … first + n - 1; `before` holds those of the step before (unused at s = 0).
  void eliminate(Unknown &unknown, int s, int first, int n, double *__restrict x, const double *__restrict before);
  /// Solves the borders between ranks. Collective.
  void meet(Unknown &unknown);
  /// Eliminated values -> solution, for s = planes - 1 … 0.
  void substitute(Unknown &unknown, int s, int first, int n, double *__restrict x);

private:
  void factor_planes(const std::vector<double> &excess);
  void next_plane(int s, const std::vector<double> &excess, std::vector<double> &plane_of_v) const;
  void store_fresh(const std::vector<double> &plane_of_v);
  void bring_plane(int s);
  void factor_borders();
  void factor_round(const std::vector<double> &excess);
  void solve_mode_0(Unknown &unknown) const;
  bool has_outer() const { return outer_ != MPI_PROC_NULL; }
  bool has_inner() const { return inner_ != MPI_PROC_NULL; }

  MPI_Comm comm_;
  int ranks_ = 1, rank_ = 0;
  int modes_, planes_, all_planes_ = 0;
  bool upward_ = true, meets_ = false;
  int outer_ = MPI_PROC_NULL, inner_ = MPI_PROC_NULL;
  Column column_;
  double scale_ = 1.0;
  // v[s](m) = 1 / (d - e^2 v[s-1]) settles after a few planes for all but the smoothest modes: those that differ from `settled_` are stored, in `ranges_` of each
  // plane, and the present plane's are written over it. So what a sweep reads of them stays in cache.
  struct Range {
    int first, count;
    std::size_t at;  // in fresh_
  };
  std::vector<double> v_, settled_, fresh_;
  int v_plane_ = 0;
  std::vector<Range> ranges_;
  std::vector<std::size_t> ranges_start_;  // of each plane, and the end
  std::vector<double> response_;  // pi[s](m), s = 0 … planes; only with an outer neighbour
  std::vector<double> round_, round_factor_;  // w[s](m), e / (1 + e s.w)(m); only where periodic
  // Borders, a value a mode. x_O = A - B x_F (outer neighbour), x_F = (y_F + f A + g x_I) / (1 + f B), x_L = A' - B' x_I.
  std::vector<double> a_, b_, f_, g_, q_, a_here_, b_here_, b_partner_, x_first_;
  std::vector<int> line_counts_, line_starts_;
};

}  // namespace swellflow
