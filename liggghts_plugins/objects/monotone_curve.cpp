#include "monotone_curve.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace swellflow {

namespace {

/// At an end, from the two gaps h and chords d beside it; no steeper than keeps the curve monotone (Moler, Numerical Computing with MATLAB, 2004, 3.4).
double end_slope(double h0, double h1, double d0, double d1)
{
  const double slope = ((2.0 * h0 + h1) * d0 - h0 * d1) / (h0 + h1);
  if (slope * d0 <= 0.0) return 0.0;
  return d0 * d1 <= 0.0 && std::abs(slope) > 3.0 * std::abs(d0) ? 3.0 * d0 : slope;
}

/// Weighted harmonic mean of the chords on both sides.
double inner_slope(double h0, double h1, double d0, double d1)
{
  if (d0 * d1 <= 0.0) return 0.0;
  const double w0 = h0 + 2.0 * h1, w1 = 2.0 * h0 + h1;
  return (w0 + w1) / (w1 / d0 + w0 / d1);
}

}  // namespace

MonotoneCurve::MonotoneCurve(std::vector<double> places, std::vector<double> values) : places_(std::move(places)), values_(std::move(values))
{
  const std::size_t n = places_.size();
  std::vector<double> h, d;
  for (std::size_t k = 1; k < n; ++k) {
    h.push_back(places_[k] - places_[k - 1]);
    d.push_back((values_[k] - values_[k - 1]) / h.back());
  }
  if (n == 2) {
    slopes_ = {d[0], d[0]};
    return;
  }
  slopes_.push_back(end_slope(h[0], h[1], d[0], d[1]));
  for (std::size_t k = 1; k + 1 < n; ++k) slopes_.push_back(inner_slope(h[k - 1], h[k], d[k - 1], d[k]));
  slopes_.push_back(end_slope(h[n - 2], h[n - 3], d[n - 2], d[n - 3]));
}

double MonotoneCurve::value(double place) const
{
  if (place <= places_.front()) return values_.front();
  if (place >= places_.back()) return values_.back();
  const std::size_t k = std::upper_bound(places_.begin(), places_.end(), place) - places_.begin() - 1;
  const double h = places_[k + 1] - places_[k], s = (place - places_[k]) / h, r = 1.0 - s;
  return r * r * ((1.0 + 2.0 * s) * values_[k] + s * h * slopes_[k]) + s * s * ((1.0 + 2.0 * r) * values_[k + 1] - r * h * slopes_[k + 1]);
}

}  // namespace swellflow
