// SPDX-License-Identifier: MIT-0
/// @file
/// Symplectic Euler: velocity first, then position.
#pragma once
#include <type_traits>

namespace integrate {

// [step]
/// One step of symplectic Euler: velocity first, then position with the new velocity.
///
/// Order 1, one evaluation of the acceleration, stable on an undamped spring while h*omega < 2.
///
/// @param x  position, advanced in place
/// @param v  velocity, advanced in place
/// @param t  time at the start of the step [s]
/// @param h  step size [s]; a negative step goes back in time
/// @param acceleration  callable `(x, v, t) -> Vec` [units of x per s^2]
/// @see Hairer, Lubich and Wanner, Geometric Numerical Integration (2006), section I.1.2
template <class Vec, class Time, class Real, class Acceleration>
constexpr void symplectic_euler(Vec& x, Vec& v, Time t, Real h, Acceleration&& acceleration) {
  static_assert(std::is_invocable_r_v<Vec, Acceleration&, const Vec&, const Vec&, Time>,
                "acceleration must be callable as Vec(x, v, t)");
  // [move]
  v = v + h * acceleration(x, v, t);
  x = x + h * v;
  // [move]
}
// [step]

}  // namespace integrate
