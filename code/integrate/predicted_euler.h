// SPDX-License-Identifier: MIT-0
/// @file
/// Backward Euler, or implicit Euler, by predictor and corrector, which is explicit after all.
///
/// @code
/// const auto spring = [](double x, double v, double) { return -9 * x - v; };
/// double x = 1, v = 0;
/// for (int n = 0; n < 60; ++n) integrate::predicted_euler(x, v, n / 60.0, 1 / 60.0, spring, 2);
/// @endcode
#pragma once
#include <type_traits>

namespace integrate {

/// One step of backward (implicit) Euler, its end found by Euler's method and then corrected.
///
/// Order 1, two evaluations of the acceleration with one correction (one more for each further
/// one), stable on drag while c*h < 1, on an undamped spring while h*omega < 1. More corrections
/// never make it stable for every h: with two the limits are 1.353 and 1.272, with three 1 again.
/// Implicit Euler proper is in backward_euler.h. On poses, order 1.
///
/// @param x  position, advanced in place
/// @param v  velocity, advanced in place
/// @param t  time at the start of the step [s]
/// @param h  step size [s]; a negative step goes back in time
/// @param acceleration  callable `(x, v, t) -> Vec` [units of x per s^2]
/// @param corrections  how often the end is put into its own formula; at least 1
/// @see Hairer, Norsett and Wanner, Solving Ordinary Differential Equations I (1993), section III.1
template <class Position, class Vec, class Time, class Real, class Acceleration>
constexpr void predicted_euler(Position& x, Vec& v, Time t, Real h, Acceleration&& acceleration,
                               int corrections = 1) {
  constexpr bool calls =
      std::is_invocable_r_v<Vec, Acceleration&, const Position&, const Vec&, Time>;
  constexpr auto scale = [](auto s, const auto& y) -> decltype(s * y) { return s * y; };
  constexpr auto add = [](const auto& y, const auto& z) -> decltype(y + z) { return y + z; };
  constexpr bool scales = std::is_invocable_r_v<Vec, decltype(scale), Real, Vec>;
  constexpr bool moves = std::is_invocable_r_v<Position, decltype(add), Position, Vec>;
  static_assert(calls, "acceleration must be callable as Vec(x, v, t)");
  static_assert(scales,
                "h * v must be a Vec: 1/60.0f for floats; copy Maps; raylib lacks float * Vector3");
  static_assert(moves, "x + h * v must be a Position, which is the type of x");
  static_assert(!std::is_integral_v<Real>, "h must be no integer");
  if constexpr (calls && scales && moves) {
    using Clock = std::common_type_t<Time, Real>;  // for -Wdouble-promotion
    const Clock t_end = Clock(t) + Clock(h);
    // [move]
    Position x_end = x + h * v;
    Vec v_end = v + h * acceleration(x, v, t);
    for (int n = 0; n < corrections; ++n) {
      const Vec a_end = acceleration(x_end, v_end, t_end);
      x_end = x + h * v_end;
      v_end = v + h * a_end;
    }
    x = x_end;
    v = v_end;
    // [move]
  }
}

}  // namespace integrate
