// SPDX-License-Identifier: MIT-0
/// @file
/// The midpoint method: Runge-Kutta of order 2.
///
/// @code
/// const auto spring = [](double x, double v, double) { return -9 * x - v; };
/// double x = 1, v = 0;
/// for (int n = 0; n < 60; ++n) integrate::midpoint(x, v, n / 60.0, 1 / 60.0, spring);
/// @endcode
#pragma once
#include <type_traits>

namespace integrate {

/// One step of the midpoint method: half a step of Euler's shows the slope for the whole step.
///
/// Order 2, two evaluations of the acceleration, stable on drag while c*h < 2, never on an undamped
/// spring. On poses, order 2.
///
/// @param x  position, advanced in place
/// @param v  velocity, advanced in place
/// @param t  time at the start of the step [s]
/// @param h  step size [s]; a negative step goes back in time
/// @param acceleration  callable `(x, v, t) -> Vec` [units of x per s^2]
/// @see C. Runge, Ueber die numerische Aufloesung von Differentialgleichungen (1895)
template <class Position, class Vec, class Time, class Real, class Acceleration>
constexpr void midpoint(Position& x, Vec& v, Time t, Real h, Acceleration&& acceleration) {
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
    const Clock t_middle = Clock(t) + Clock(h / Real(2));
    // [move]
    const Position x_middle = x + (h / Real(2)) * v;
    const Vec v_middle = v + (h / Real(2)) * acceleration(x, v, t);
    x = x + h * v_middle;
    v = v + h * acceleration(x_middle, v_middle, t_middle);
    // [move]
  }
}

}  // namespace integrate
