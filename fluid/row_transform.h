// Fast transforms of rows of cells, two rows at a time.
#pragma once

#include <fftw3.h>

#include <memory>

#include "fluid/reals.h"

namespace swellflow {

/// What an unknown in cell centres does at an end of a direction.
enum class End {
  value,     ///< zero on the side, half a cell outside: the ghost is minus the first cell
  gradient,  ///< zero gradient: the ghost equals the first cell
  periodic   ///< at both ends or at none
};

struct Ends {
  End lower, upper;
  bool operator==(const Ends &) const = default;
  bool periodic() const { return lower == End::periodic; }
  bool alike() const { return lower == upper; }
};

/// The eigenvectors of the second difference on n cells: cosines for gradients, sines for values, half-odd ones between unlike ends, waves where periodic.
///
/// Two rows go through one complex transform of length n, as its real and imaginary part. Cosines: the even cells followed by the odd ones in reverse are
/// transformed, and a rotation gives DCT-II (Makhoul, IEEE Trans. ASSP 28, 1980). Sines: DST-II of x is DCT-II of (-1)^j x_j with its modes in reverse; they stay so.
/// That is three times faster than FFTW's transforms of even, odd and real rows, which do not use the processor's vectors (docs/performance.md); rows with
/// unlike ends take those, DCT-IV and DST-IV.
class RowTransform {
public:
  struct Row {
    double *values;
    Ends ends;
  };

  explicit RowTransform(int n);

  /// In place: cell values -> modes. b.values may be null; both rows are periodic or none is.
  void to_modes(const Row &a, const Row &b);
  /// And back, multiplied by 2 n.
  void to_cells(const Row &a, const Row &b);

  /// Of minus the second difference (times h^2), for the mode that lies at i.
  static double eigenvalue(const Ends &ends, int n, int i);

private:
  struct DestroyPlan {
    void operator()(fftw_plan p) const { fftw_destroy_plan(p); }
  };
  using Plan = std::unique_ptr<std::remove_pointer_t<fftw_plan>, DestroyPlan>;

  struct Rotation {
    Rotation(int n, bool folded);
    Reals cosine, sine;
  };

  bool alone(const Row &a, const Row &b, void (RowTransform::*transform)(const Row &, const Row &));
  void half_odd(const Row &row);
  double *second(const Row &b);

  int n_;
  Reals re_, im_, mode_re_, mode_im_, spare_;
  Rotation folded_, plain_;
  Plan forward_, backward_, half_odd_cosines_, half_odd_sines_;
};

}  // namespace swellflow
