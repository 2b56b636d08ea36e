// A smooth curve through given points that makes no hills or valleys of its own.
#pragma once

#include <vector>

namespace swellflow {

/// Piecewise cubic with the slopes of Fritsch and Butland, SIAM J. Sci. Stat. Comput. 5, 300 (1984): between two points it is monotone. Beyond both ends it
/// keeps the value there.
class MonotoneCurve {
public:
  /// At least two places, ascending, and as many values.
  MonotoneCurve(std::vector<double> places, std::vector<double> values);
  double value(double place) const;
  const std::vector<double> &places() const { return places_; }

private:
  std::vector<double> places_, values_, slopes_;
};

}  // namespace swellflow
