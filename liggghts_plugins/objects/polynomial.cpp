#include "polynomial.h"

namespace swellflow {

std::vector<double> derivative(const std::vector<double> &coefficients)
{
  std::vector<double> result;
  for (std::size_t k = 1; k < coefficients.size(); ++k) result.push_back(k * coefficients[k]);
  return result;
}

namespace {

/// The polynomial has one sign at `low` and another at `high`.
double bisected(const std::vector<double> &coefficients, double low, double high)
{
  const bool rises = polynomial(coefficients, low) < 0.0;
  for (double middle = 0.5 * (low + high); middle > low && middle < high; middle = 0.5 * (low + high))
    ((polynomial(coefficients, middle) < 0.0) == rises ? low : high) = middle;
  return high;
}

}  // namespace

/// Between the roots of the derivative the polynomial is monotone and has one root at most.
std::vector<double> roots(const std::vector<double> &coefficients, double low, double high)
{
  if (coefficients.size() < 2) return {};
  std::vector<double> ends = roots(derivative(coefficients), low, high), found;
  ends.insert(ends.begin(), low);
  ends.push_back(high);
  for (std::size_t k = 1; k < ends.size(); ++k)
    if ((polynomial(coefficients, ends[k - 1]) < 0.0) != (polynomial(coefficients, ends[k]) < 0.0))
      found.push_back(bisected(coefficients, ends[k - 1], ends[k]));
  return found;
}

}  // namespace swellflow
