// The impulses after whose spreading the fluid has the wanted velocities at the markers.
#pragma once

#include <Eigen/Core>

#include "fluid/markers.h"

namespace swellflow {

/// Wanted are impulses J whose spreading changes the interpolated velocities by W. With A = interpolation after spreading,
///
///     A J = W        (the forces of Taira & Colonius, J. Comput. Phys. 225, 2007, eq. 27, before the projection; what the loops of multi-direct forcing,
///                     Kempe & Froehlich, J. Comput. Phys. 231, 2012, converge to)
///
/// As unknown g = J / m serves the velocity that a marker gives to the fluid around it, m = rho ds h: A m is self-adjoint in the inner product
/// sum m a b, and its eigenvalues, between 0 and about 1, do not grow with the number of markers. But where markers are denser than cells, some of them are
/// close to 0 (in the limit it is an integral equation of the first kind: Goza, Liska, Morley & Colonius, J. Comput. Phys. 321, 2016): alternating
/// impulses that the fluid does not feel. Hence iterated regularisation (King & Chillingworth, Numer. Funct. Anal. Optim. 1, 1979), twice:
///
///     (A m + eps) g1 = W,     (A m + eps) g2 = W - A m g1 = eps g1,     J = m (g1 + g2)
///
/// What is left of W is ( eps / (lambda + eps) )^2 of each mode: with eps = 0.005 less than 2e-4 of the smooth modes (lambda from 0.37 on), and modes of
/// lambda << eps stay out of J. Measured on circles of radius 5 to 10 cells, at any place, as slip over the largest velocity asked for:
///
///                                                         Roma 1999   Peskin 2002   Yang 2009
///     W of smooth impulses, gaps of 0.25 to 3 cells       1.3e-4      2.2e-4        1.5e-4
///     W smooth along the outline, gaps from 1.5 on        1.2e-4      2.5e-4        1.7e-4
///                                 gap 1                   3.7e-4      1.7e-3        8.1e-4
///                                 gaps 0.25 and 0.5       1.6e-2      8.0e-3        3.4e-3       (what only alternating impulses could give)
///     largest g, gaps 0.25 and 0.5; 1                     6.8; 2.3    5.1; 3.7      3.7; 2.9
///     iterations, gaps 0.25 to 0.75; 1; 3                 177;103;9   137;134;15    167;119;15
///
/// Solved once with eps = 3e-4, gap 1 takes half the iterations and smaller ones a quarter more, four times as much of the smooth modes is left, and on the
/// dense circles g grows to 36, 23 and 8.5 for no more than a third less slip.
///
/// Each system is solved by conjugate gradients in that inner product, matrix-free, with A by Markers::spread, FaceForcing::complete and
/// Markers::interpolate. A does not couple the components: their systems are solved in lockstep, each with its own step lengths, until
/// all residuals are below `tolerance` times W in the norm of that inner product. From zero, so that nothing depends on the past.
template <int Dim> class MarkerSolver {
public:
  static constexpr double regularisation = 5e-3;  ///< eps
  static constexpr double tolerance = 1e-13;      ///< so that another order of sums, as on other ranks, changes J by about 1e-11

  /// The markers are those placed when `solve` is called. At most max_iterations for each of the two systems. Collective.
  MarkerSolver(const Grid<Dim> &grid, const Layout<Dim> &layout, const Markers<Dim> &markers, int max_iterations = 1000)
      : grid_(grid), markers_(markers), forcing_(grid, layout), max_iterations_(max_iterations)
  {
  }

  /// spacing: the length (2-D) or area (3-D) of outline that a marker stands for; change: W. Ranks without markers take part. Throws std::runtime_error, on every
  /// rank alike, when the iterations do not converge. Collective.
  void solve(std::span<const double> spacing, const std::vector<Vec<Dim>> &change, double density, std::vector<Vec<Dim>> &impulses);

  int iterations() const { return iterations_; }  ///< of the last `solve`, both systems together

private:
  using PerMarker = Eigen::Array<double, Dim, Eigen::Dynamic>;  // a column a marker
  using PerComponent = Eigen::Array<double, Dim, 1>;

  void solve_regularised(const PerComponent &goal, double density);
  void apply(double density);
  PerComponent dot(const PerMarker &a, const PerMarker &b) const;
  [[noreturn]] void fail(const PerComponent &square, const PerComponent &goal) const;

  const Grid<Dim> &grid_;
  const Markers<Dim> &markers_;
  FaceForcing<Dim> forcing_;
  const int max_iterations_;
  int iterations_ = 0;

  Eigen::Array<double, 1, Eigen::Dynamic> mass_;
  PerMarker g_, step_, residual_, direction_, image_;  // g_ the sum over both systems, step_ of the present one
  std::vector<Vec<Dim>> spread_, returned_;
};

extern template class MarkerSolver<2>;
extern template class MarkerSolver<3>;

}  // namespace swellflow
