#include "swelling_laws.h"

#include <cmath>
#include <numbers>

#include "polynomial.h"

namespace swellflow {

using std::numbers::pi;

SmallestSize smallest_size(const SwellingLaw &law, double start, double from, double to)
{
  SmallestSize smallest{.diameter = std::numeric_limits<double>::infinity(), .elapsed = from};
  const auto look = [&](double elapsed) {
    const double diameter = law.diameter(start, elapsed);
    if (!std::isfinite(diameter))
      smallest = {.diameter = std::numeric_limits<double>::quiet_NaN(), .elapsed = elapsed};
    else if (diameter < smallest.diameter)  // never once one was not a number
      smallest = {.diameter = diameter, .elapsed = elapsed};
  };
  look(from);
  for (double elapsed : law.turning_times())
    if (elapsed > from && elapsed < to) look(elapsed);
  look(to);
  return smallest;
}

PolynomialSwelling::PolynomialSwelling(SizeKind kind, std::vector<double> coefficients, double until) :
    kind_(kind), coefficients_(std::move(coefficients)), turning_times_(roots(derivative(coefficients_), 0.0, until)), until_(until)
{
  turning_times_.push_back(until);
}

double PolynomialSwelling::diameter(double start, double elapsed) const
{
  return diameter_of(kind_, start, polynomial(coefficients_, std::min(elapsed, until_)));
}

PolynomialSwelling hydrogel_swelling(HydrogelForm form, double millimetre, double second)
{
  constexpr double last_observed = 34920.0;  // 9.7 hours
  std::vector<double> coefficients = {2.98, 0.002, -1.85e-7, 1.04e-11, -3.36e-16, 5.88e-21, -4.38e-26};
  if (form == HydrogelForm::reconstructed)
    coefficients = {2.97764, 1.86646e-3, -1.84764e-7, 1.04236e-11, -3.35764e-16, 5.88236e-21, -4.37764e-26};
  double unit = millimetre;
  for (double &coefficient : coefficients) {
    coefficient *= unit;
    unit /= second;
  }
  return {SizeKind::diameter, coefficients, last_observed * second};
}

double TanakaFillmoreSwelling::tau_of(double final_diameter, double diffusivity)
{
  return final_diameter * final_diameter / (4.0 * pi * pi * diffusivity);
}

double TanakaFillmoreSwelling::diameter(double start, double elapsed) const
{
  const double fraction = swelling_fraction(elapsed / tau(start));
  return (1.0 - fraction) * start + fraction * final_diameter(start);
}

/// Crank, The Mathematics of Diffusion, 2nd ed. (1975): the series eq. (6.20), and for small times eq. (6.22) with D t/a^2 = x/pi^2. From x = 1 on
/// six terms of the one are exact to round-off, before it one term of the other: the second is below exp(-4 pi^2).
double swelling_fraction(double x)
{
  if (x <= 0.0) return 0.0;
  if (x < 1.0) {
    const double root = std::sqrt(x), z = pi / root;
    const double ierfc = std::exp(-z * z) / std::sqrt(pi) - z * std::erfc(z);
    return 6.0 * root / pi * (1.0 / std::sqrt(pi) + 2.0 * ierfc) - 3.0 * x / (pi * pi);
  }
  double sum = 0.0;
  for (int n = 6; n >= 1; --n) sum += std::exp(-n * n * x) / (n * n);
  return 1.0 - 6.0 / (pi * pi) * sum;
}

}  // namespace swellflow
