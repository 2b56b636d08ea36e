// Polynomials of one variable: coefficient k belongs to the power k.
#pragma once

#include <vector>

namespace swellflow {

/// By Horner's rule.
inline double polynomial(const std::vector<double> &coefficients, double x)
{
  double sum = 0.0;
  for (std::size_t k = coefficients.size(); k-- > 0;) sum = sum * x + coefficients[k];
  return sum;
}

std::vector<double> derivative(const std::vector<double> &coefficients);

/// Where the polynomial changes its sign between `low` and `high`, ascending.
std::vector<double> roots(const std::vector<double> &coefficients, double low, double high);

}  // namespace swellflow
