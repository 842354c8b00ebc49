// SPDX-License-Identifier: MIT-0
/// @file
/// Heun's method: predict with Euler, correct with the mean of two slopes.
///
/// @code
/// const auto spring = [](double x, double v, double) { return -9 * x - v; };
/// double x = 1, v = 0;
/// for (int n = 0; n < 60; ++n) integrate::heun(x, v, n / 60.0, 1 / 60.0, spring);
/// @endcode
#pragma once
#include <type_traits>

namespace integrate {

/// One step of Heun's method: Euler predicts the end, the mean of both ends' slopes is taken.
///
/// Order 2, two evaluations of the acceleration, stable on drag while c*h < 2, never on an undamped
/// spring. On poses, order 2.
///
/// @param x  position, advanced in place
/// @param v  velocity, advanced in place
/// @param t  time at the start of the step [s]
/// @param h  step size [s]; a negative step goes back in time
/// @param acceleration  callable `(x, v, t) -> Vec` [units of x per s^2]
/// @see K. Heun, Neue Methoden zur approximativen Integration (1900)
template <class Position, class Vec, class Time, class Real, class Acceleration>
constexpr void heun(Position& x, Vec& v, Time t, Real h, Acceleration&& acceleration) {
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
    const Vec a = acceleration(x, v, t);
    const Position x_end = x + h * v;
    const Vec v_end = v + h * a;
    const Vec a_end = acceleration(x_end, v_end, t_end);
    x = x + (h / Real(2)) * (v + v_end);
    v = v + (h / Real(2)) * (a + a_end);
    // [move]
  }
}

}  // namespace integrate
