// SPDX-License-Identifier: MIT-0
/// @file
/// The book's own sine and cosine: the same bits on every machine.
#pragma once
#include <limits>
#include <type_traits>

namespace scenes {

/// What sine() and cosine() are made of.
namespace sine_parts {

/// An angle as a whole number of quarter turns and a rest of at most an eighth of a turn.
struct Reduced {
  long long quarters;  ///< four of them are a full turn
  double angle;        ///< the rest [rad]
  double tail;         ///< what rounding took from `angle` [rad]
};

/// Takes away the quarter turns, with pi/2 as a sum of three numbers.
///
/// The first two have 33 bits, so that their products with up to 2^20 quarters are exact.
/// @param x  an angle, at most 1e5 in size [rad]
/// @see W. J. Cody and W. Waite, Software Manual for the Elementary Functions (1980), chapter 8
constexpr Reduced reduce(double x) {
  const double turns = x * 0x1.45f306dc9c883p-1;
  const auto quarters = static_cast<long long>(turns + (turns < 0 ? -0.5 : 0.5));
  const auto n = static_cast<double>(quarters);
  const double first = x - n * 0x1.921fb544p+0;
  const double second = n * 0x1.0b4611a6p-34;
  const double near = first - second;
  const double taken = near - first;
  const double lost = (first - (near - taken)) - (second + taken);
  const double third = lost - n * 0x1.3198a2e037073p-69;
  const double angle = near + third;
  return {quarters, angle, (near - angle) + third};
}

/// Taylor's coefficients of (sin r - r) / r^3, in powers of r^2.
inline constexpr double sine_series[] = {
    -1.0 / 6,        1.0 / 120,        -1.0 / 5040,          1.0 / 362880,
    -1.0 / 39916800, 1.0 / 6227020800, -1.0 / 1307674368000, 1.0 / 355687428096000};

/// Taylor's coefficients of (cos r - 1 + r^2/2) / r^4, in powers of r^2.
inline constexpr double cosine_series[] = {
    1.0 / 24,        -1.0 / 720,         1.0 / 40320,         -1.0 / 3628800,
    1.0 / 479001600, -1.0 / 87178291200, 1.0 / 20922789888000};

/// A polynomial, by Horner's rule.
/// @param coefficients  the constant first
/// @param z  where to evaluate it
template <int N>
constexpr double polynomial(const double (&coefficients)[N], double z) {
  double sum = 0;
  for (int n = N - 1; n >= 0; --n) sum = coefficients[n] + z * sum;
  return sum;
}

/// The sine of a small angle. What the series leaves out is less than rounding.
/// @param r  an angle, at most pi/4 in size [rad]
/// @param tail  what rounding took from `r` [rad]
constexpr double small_sine(double r, double tail) {
  const double z = r * r;
  return r + (r * z * polynomial(sine_series, z) + tail * (1 - 0.5 * z));
}

/// The cosine of a small angle, with the rounding of 1 - r^2/2 made good.
/// @param r  an angle, at most pi/4 in size [rad]
/// @param tail  what rounding took from `r` [rad]
constexpr double small_cosine(double r, double tail) {
  const double z = r * r;
  const double top = 1 - 0.5 * z;
  return top + (((1 - top) - 0.5 * z) + (z * z * polynomial(cosine_series, z) - r * tail));
}

/// The sine of an angle that is given in quarter turns and a rest.
/// @param x  the rest
/// @param quarters  how many quarter turns to add to those of `x`
constexpr double wave(const Reduced& x, long long quarters) {
  const long long part = (x.quarters + quarters) & 3;
  const double size = part % 2 == 0 ? small_sine(x.angle, x.tail) : small_cosine(x.angle, x.tail);
  return part < 2 ? size : -size;
}

/// The sine of x plus a number of quarter turns, or not a number.
/// @tparam Real  `double` or `float`
/// @param x  an angle [rad]
/// @param quarters  how many quarter turns to add
template <class Real>
constexpr Real shifted_sine(Real x, long long quarters) {
  static_assert(std::is_same_v<Real, double> || std::is_same_v<Real, float>,
                "sine and cosine take a double or a float");
  if (!(x >= Real(-1e5) && x <= Real(1e5))) return std::numeric_limits<Real>::quiet_NaN();
  return static_cast<Real>(wave(reduce(static_cast<double>(x)), quarters));
}

}  // namespace sine_parts

/// The sine, less than one unit in the last place off, with the same bits on every machine.
///
/// No two C libraries agree on the last bit of a sine, and a pendulum makes much of a last bit.
/// This one needs only + - * and comparisons, which IEEE 754 settles. A float is computed as a
/// double.
/// @tparam Real  `double` or `float`
/// @param x  an angle, at most 1e5 in size [rad]; the sine of anything else is not a number
template <class Real>
constexpr Real sine(Real x) {
  return sine_parts::shifted_sine(x, 0);
}

/// The cosine, as good as sine().
/// @tparam Real  `double` or `float`
/// @param x  an angle, at most 1e5 in size [rad]; the cosine of anything else is not a number
template <class Real>
constexpr Real cosine(Real x) {
  return sine_parts::shifted_sine(x, 1);
}

}  // namespace scenes
