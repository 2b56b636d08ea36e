// Numbers of cells that are square, for `cells auto`.
#pragma once

#include <array>

namespace swellflow {

/// Cells across a box of these lengths, square to what fix fluid/ib accepts, whose side is nearest to `wanted` by ratio. Throws std::invalid_argument, with what would fit, when none is within
/// a quarter of it.
std::array<int, 2> square_cells(const std::array<double, 2> &length, double wanted);

}  // namespace swellflow
