// SPDX-License-Identifier: MIT-0
/// @file
/// Euler's method, for a sample.
///
/// @code
/// double x = 1, v = 0;
/// integrate::euler(x, v, 0.0, 0.1, [](double x, double, double) { return -x; });
/// @endcode
#pragma once

namespace integrate {

// [all]
/// One step of Euler's method: position first, then velocity, both with the old values.
///
/// Order 1, one evaluation of the acceleration, unstable on an undamped spring for every \f$ h \f$.
///
/// @param x  position, advanced in place
/// @param v  velocity, advanced in place
/// @param t  time at the start of the step [s]
/// @param h  step size [s]
/// @param acceleration  callable `(x, v, t) -> Vec` [units of x per s^2]
/// @see Hairer, Lubich and Wanner, Geometric Numerical Integration (2006)
template <class Vec, class Time, class Real, class Acceleration>
constexpr void euler(Vec& x, Vec& v, Time t, Real h, Acceleration&& acceleration) {
  // [step]
  const Vec a = acceleration(x, v, t);
  // [position]
  x = x + h * v;  // the old velocity
  // [position]
  v = v + h * a;
  // [step]
}
// [all]

}  // namespace integrate
