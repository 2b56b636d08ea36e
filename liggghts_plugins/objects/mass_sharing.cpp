#include "mass_sharing.h"

#include <Eigen/LU>
#include <algorithm>
#include <stdexcept>
#include <string>

namespace swellflow {

std::vector<double> centred_weights(const std::vector<Shape::RingPoint> &ring, const Polygon &outline)
{
  constexpr double least = 0.05;  // of the mean; a lighter point would vibrate too fast
  const std::size_t n = ring.size();
  std::vector<double> weights(n);
  double sum = 0.0;
  for (std::size_t k = 0; k < n; ++k) {
    const Vector2 &before = outline[k > 0 ? k - 1 : n - 1], &behind = outline[after(outline, k)];
    sum += weights[k] = (outline[k] - before).norm() + (behind - outline[k]).norm();
  }
  // sum w (1 + a.x) = sum w needs no equation of its own when the common factor is put right afterwards.
  Vector2 moment = Vector2::Zero();
  Eigen::Matrix2d second_moment = Eigen::Matrix2d::Zero();
  for (std::size_t k = 0; k < n; ++k) {
    moment += weights[k] * ring[k].x;
    second_moment += weights[k] * ring[k].x * ring[k].x.transpose();
  }
  const Vector2 a = -second_moment.inverse() * moment;
  const double factor = n / (sum + a.dot(moment));
  for (std::size_t k = 0; k < n; ++k) {
    weights[k] *= factor * (1.0 + a.dot(ring[k].x));
    if (weights[k] < least)
      throw std::invalid_argument("ring points must be able to have their centre of mass at the centroid, but point " + std::to_string(k + 1) +
                                  " would be left with hardly any mass: use more or other points, or 'mass equal'");
  }
  return weights;
}

double hub_share_for_inertia(const Shape &shape)
{
  constexpr double least = 0.01;  // a lighter hub would vibrate too fast
  double of_ring = 0.0;
  const double n = static_cast<double>(shape.ring.size());
  if (shape.is_round)
    of_ring = shape.ring[0].spoke_length * shape.ring[0].spoke_length;
  else
    for (const Shape::RingPoint &point : shape.ring) of_ring += point.weight / n * point.x.squaredNorm();
  const double share = 1.0 - shape.mean_square_radius / of_ring;
  if (share < least)
    throw std::invalid_argument("the points must be able to have the moment of inertia of the solid shape, but the ring lies so far inside that this leaves " +
                                std::to_string(share) + " of the mass for the hub: raise 'reach', lower 'cds', or use 'mass equal'");
  return share;
}

}  // namespace swellflow
