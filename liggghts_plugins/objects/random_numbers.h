// A series of random numbers that depends on a seed alone. Free of LIGGGHTS.
#pragma once

#include "random_factor.h"

namespace swellflow {

class RandomNumbers {
public:
  RandomNumbers(Purpose purpose, std::uint64_t seed) : purpose_(purpose), seed_(seed) {}

  /// Uniform in (0, 1).
  double next() { return uniform_number(purpose_, seed_, 0, drawn_++); }

private:
  Purpose purpose_;
  std::uint64_t seed_, drawn_ = 0;
};

}  // namespace swellflow
