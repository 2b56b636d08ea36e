#include "fluid/row_transform.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

namespace swellflow {

namespace {

Reals zeros(int n)
{
  Reals values = allocate_reals(n);
  std::fill_n(values.get(), n, 0.0);
  return values;
}

double sign_of_odd(const Ends &ends) { return ends.lower == End::value ? -1.0 : 1.0; }

/// Even cells, then odd ones backwards; waves as they are.
void fold(const double *__restrict row, int n, const Ends &ends, double *__restrict out)
{
  if (ends.periodic()) {
    std::copy_n(row, n, out);
    return;
  }
  const double sign = sign_of_odd(ends);
  const int evens = (n + 1) / 2, odds = n / 2;
  for (int j = 0; j < evens; ++j) out[j] = row[2 * j];
  double *__restrict back = out + n - odds;
  for (int j = 0; j < odds; ++j) back[j] = sign * row[2 * (odds - 1 - j) + 1];
}

void unfold(const double *__restrict in, int n, const Ends &ends, double *__restrict row)
{
  if (ends.periodic()) {
    std::copy_n(in, n, row);
    return;
  }
  const double sign = sign_of_odd(ends);
  const int odds = n / 2;
  const double *__restrict back = in + n - odds;
  for (int j = 0; j < odds; ++j) {
    row[2 * j] = in[j];
    row[2 * j + 1] = sign * back[odds - 1 - j];
  }
  if (n % 2) row[n - 1] = in[n / 2];
}

}  // namespace

// Estimated plans: measured ones differ from run to run, and with them the last bits of the result.
RowTransform::RowTransform(int n)
    : n_(n), re_(zeros(n)), im_(zeros(n)), mode_re_(zeros(n)), mode_im_(zeros(n)), spare_(zeros(n)), folded_(n, true), plain_(n, false)
{
  const fftw_iodim size = {n, 1, 1};
  forward_.reset(fftw_plan_guru_split_dft(1, &size, 0, nullptr, re_.get(), im_.get(), mode_re_.get(), mode_im_.get(), FFTW_ESTIMATE));
  // The inverse is the transform with real and imaginary parts exchanged.
  backward_.reset(fftw_plan_guru_split_dft(1, &size, 0, nullptr, mode_im_.get(), mode_re_.get(), im_.get(), re_.get(), FFTW_ESTIMATE));
  half_odd_cosines_.reset(fftw_plan_r2r_1d(n, re_.get(), re_.get(), FFTW_REDFT11, FFTW_ESTIMATE));
  half_odd_sines_.reset(fftw_plan_r2r_1d(n, re_.get(), re_.get(), FFTW_RODFT11, FFTW_ESTIMATE));
  if (!forward_ || !backward_ || !half_odd_cosines_ || !half_odd_sines_)
    throw std::runtime_error("FFTW made no plan for a row of " + std::to_string(n) + " cells");
}

// The middle mode has no partner: what the two halves of the loop below write is the same.
RowTransform::Rotation::Rotation(int n, bool folded) : cosine(zeros(n)), sine(zeros(n))
{
  for (int k = 0; k < n; ++k) {
    const double angle = folded || 2 * k == n ? 0.5 * std::numbers::pi * k / n : 0.0;
    cosine.get()[k] = std::cos(angle);
    sine.get()[k] = std::sin(angle);
  }
}

double RowTransform::eigenvalue(const Ends &ends, int n, int i)
{
  double waves = i;                                          // half waves in the row
  if (ends.periodic()) waves = 2.0 * std::min(i, n - i);
  else if (!ends.alike()) waves = i + 0.5;
  else if (ends.lower == End::value) waves = n - i;
  const double s = std::sin(0.5 * std::numbers::pi * waves / n);
  return 4.0 * s * s;
}

/// The second row, or one of zeros in its place.
double *RowTransform::second(const Row &b)
{
  if (!b.values) std::fill_n(spare_.get(), n_, 0.0);
  return b.values ? b.values : spare_.get();
}

void RowTransform::half_odd(const Row &row)
{
  std::copy_n(row.values, n_, re_.get());
  fftw_execute((row.ends.lower == End::value ? half_odd_sines_ : half_odd_cosines_).get());
  std::copy_n(re_.get(), n_, row.values);
}

/// Rows with unlike ends are transformed alone; true when that is done, both ways alike.
bool RowTransform::alone(const Row &a, const Row &b, void (RowTransform::*transform)(const Row &, const Row &))
{
  if (a.ends.alike() && (!b.values || b.ends.alike())) return false;
  for (const Row &row : {a, b}) {
    if (!row.values) continue;
    if (row.ends.alike()) (this->*transform)(row, {nullptr, row.ends});
    else half_odd(row);
  }
  return true;
}

// Z = A + iB gives A_k = (Z_k + conj Z_{n-k}) / 2 and B_k = (Z_k - conj Z_{n-k}) / 2i; X_k and X_{n-k} are 2 Re and -2 Im of A_k, for folded rows after a turn by
// exp(-i pi k / 2n), which makes them those of DCT-II.
void RowTransform::to_modes(const Row &a, const Row &b)
{
  if (alone(a, b, &RowTransform::to_modes)) return;
  double *second_row = second(b);
  fold(a.values, n_, a.ends, re_.get());
  fold(second_row, n_, b.ends, im_.get());
  fftw_execute(forward_.get());
  const Rotation &rotation = a.ends.periodic() ? plain_ : folded_;
  const int n = n_;
  const double *__restrict zr = mode_re_.get(), *__restrict zi = mode_im_.get(), *__restrict cosine = rotation.cosine.get(), *__restrict sine = rotation.sine.get();
  double *__restrict x = a.values, *__restrict y = second_row;
  x[0] = 2.0 * zr[0];
  y[0] = 2.0 * zi[0];
#pragma GCC ivdep
  for (int k = 1; k <= n / 2; ++k) {
    const int m = n - k;
    const double c = cosine[k], s = sine[k];
    const double ar = zr[k] + zr[m], ai = zi[k] - zi[m], br = zi[k] + zi[m], bi = zr[m] - zr[k];
    x[k] = c * ar + s * ai;
    y[k] = c * br + s * bi;
    x[m] = s * ar - c * ai;
    y[m] = s * br - c * bi;
  }
}

void RowTransform::to_cells(const Row &a, const Row &b)
{
  if (alone(a, b, &RowTransform::to_cells)) return;
  double *second_row = second(b);
  const Rotation &rotation = a.ends.periodic() ? plain_ : folded_;
  const int n = n_;
  double *__restrict zr = mode_re_.get(), *__restrict zi = mode_im_.get();
  const double *__restrict cosine = rotation.cosine.get(), *__restrict sine = rotation.sine.get();
  const double *__restrict x = a.values, *__restrict y = second_row;
  zr[0] = x[0];
  zi[0] = y[0];
#pragma GCC ivdep
  for (int k = 1; k <= n / 2; ++k) {
    const int m = n - k;
    const double c = cosine[k], s = sine[k];
    const double ar = c * x[k] + s * x[m], ai = s * x[k] - c * x[m], br = c * y[k] + s * y[m], bi = s * y[k] - c * y[m];
    zr[k] = ar - bi;
    zi[k] = ai + br;
    zr[m] = ar + bi;
    zi[m] = br - ai;
  }
  fftw_execute(backward_.get());
  unfold(re_.get(), n, a.ends, a.values);
  unfold(im_.get(), n, b.ends, second_row);
}

}  // namespace swellflow
