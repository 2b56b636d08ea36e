#include "fluid/marker_solver.h"

#include <cmath>
#include <sstream>

namespace swellflow {

namespace {

template <int Dim> auto columns(std::vector<Vec<Dim>> &v)
{
  return Eigen::Map<Eigen::Array<double, Dim, Eigen::Dynamic>>(v.empty() ? nullptr : v.front().data(), Dim, static_cast<Eigen::Index>(v.size()));
}

template <int Dim> auto columns(const std::vector<Vec<Dim>> &v)
{
  return Eigen::Map<const Eigen::Array<double, Dim, Eigen::Dynamic>>(v.empty() ? nullptr : v.front().data(), Dim, static_cast<Eigen::Index>(v.size()));
}

}  // namespace

template <int Dim>
void MarkerSolver<Dim>::solve(std::span<const double> spacing, const std::vector<Vec<Dim>> &change, double density, std::vector<Vec<Dim>> &impulses)
{
  const auto n = static_cast<Eigen::Index>(spacing.size());
  mass_ = density * grid_.h * Eigen::Map<const Eigen::Array<double, 1, Eigen::Dynamic>>(spacing.data(), n);
  spread_.resize(spacing.size());
  iterations_ = 0;

  residual_ = columns<Dim>(change);
  const PerComponent goal = PerComponent::Constant(tolerance * tolerance * dot(residual_, residual_).sum());
  solve_regularised(goal, density);
  g_ = step_;
  residual_ += regularisation * step_;  // W - A m g
  solve_regularised(goal, density);
  g_ += step_;

  impulses.resize(spacing.size());
  columns<Dim>(impulses) = g_.rowwise() * mass_;
}

/// (A m + eps) step_ = residual_; residual_ then is what is left of it. Components that are there stand still.
template <int Dim> void MarkerSolver<Dim>::solve_regularised(const PerComponent &goal, double density)
{
  step_.setZero(Dim, mass_.size());
  direction_ = residual_;
  PerComponent square = dot(residual_, residual_);
  for (int i = 0; !(square <= goal).all(); ++i, ++iterations_) {
    if (i == max_iterations_ || !square.isFinite().all()) fail(square, goal);
    apply(density);
    const PerComponent length = (square > goal).select(square / dot(direction_, image_), 0.0);
    step_ += direction_.colwise() * length;
    residual_ -= image_.colwise() * length;
    const PerComponent before = square;
    square = dot(residual_, residual_);
    const PerComponent turn = (before > goal).select(square / before, 0.0);
    direction_ = residual_ + direction_.colwise() * turn;
  }
}

/// image_ = (A m + eps) direction_
template <int Dim> void MarkerSolver<Dim>::apply(double density)
{
  columns<Dim>(spread_) = direction_.rowwise() * mass_;
  forcing_.clear();
  markers_.spread(spread_, density, forcing_);
  forcing_.complete();
  markers_.interpolate(forcing_.field(), returned_);
  image_ = columns<Dim>(returned_) + regularisation * direction_;
}

template <int Dim> typename MarkerSolver<Dim>::PerComponent MarkerSolver<Dim>::dot(const PerMarker &a, const PerMarker &b) const
{
  PerComponent sum = ((a * b).rowwise() * mass_).rowwise().sum();
  MPI_Allreduce(MPI_IN_PLACE, sum.data(), Dim, MPI_DOUBLE, MPI_SUM, grid_.comm);
  return sum;
}

template <int Dim> void MarkerSolver<Dim>::fail(const PerComponent &square, const PerComponent &goal) const
{
  std::ostringstream text;
  text << "the impulses on the fluid's markers did not converge: after " << iterations_ << " iterations, at most " << max_iterations_
       << " for each of two systems, the residual is " << std::sqrt((square / goal).maxCoeff()) * tolerance
       << " of the velocities asked for, but must be at most " << tolerance << "; look for objects that have run away or crumpled";
  throw std::runtime_error(text.str());
}

template class MarkerSolver<2>;
template class MarkerSolver<3>;

}  // namespace swellflow
