#include "square_cells.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "options.h"

namespace swellflow {

namespace {

constexpr int least = 4;           // as `cells NX NY`
constexpr double most = 46340.0;   // whose square is an int
constexpr double exact = 1e-9;     // relative: two sides of a cell are alike
constexpr double far = 1.25;       // sides may be by so much longer or shorter than wanted

void require_number(const std::array<double, 2> &length, double wanted)
{
  for (const double along : length)
    if (along / wanted < least / far || along / wanted > most / far)
      throw std::invalid_argument("there must be " + std::to_string(least) + " to " + shown(most) + " cells along a side, but cells of about " + rounded(wanted) + " would be " +
                                  rounded(along / wanted) + " along " + shown(along) + ": give 'cells NX NY'");
}

/// A box as high as whole cells are, nearest to the one there is.
[[noreturn]] void refuse(const std::array<double, 2> &length, double wanted)
{
  const double nx = std::max<double>(least, std::round(length[0] / wanted)), h = length[0] / nx, ny = std::max<double>(least, std::round(length[1] / h));
  throw std::invalid_argument("the fluid's cells must be square, but no whole numbers of cells of about " + rounded(wanted) + " fill a box of " + shown(length[0]) + " x " + shown(length[1]) +
                              ": make it " + shown(length[0]) + " x " + shown(ny * h) + ", which has " + shown(nx) + " x " + shown(ny) + " cells, or give 'cells NX NY'");
}

}  // namespace

std::array<int, 2> square_cells(const std::array<double, 2> &length, double wanted)
{
  require_number(length, wanted);
  const double first = std::ceil(length[0] / (wanted * far)), last = std::floor(length[0] * far / wanted);
  double nearest = far;
  std::array<int, 2> cells{0, 0};
  for (double nx = std::max<double>(first, least); nx <= last; ++nx) {
    const double h = length[0] / nx, ny = std::round(length[1] / h), off = std::max(h / wanted, wanted / h);
    if (ny < least || std::abs(length[1] / ny - h) > exact * h || off > nearest) continue;
    nearest = off;
    cells = {static_cast<int>(nx), static_cast<int>(ny)};
  }
  if (cells[0] == 0) refuse(length, wanted);
  return cells;
}

}  // namespace swellflow
