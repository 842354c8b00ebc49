// SPDX-License-Identifier: MIT-0
/// @file
/// Runge-Kutta 4: four slopes, weighted 1, 2, 2, 1.
///
/// @code
/// const auto spring = [](double x, double v, double) { return -9 * x - v; };
/// double x = 1, v = 0;
/// for (int n = 0; n < 60; ++n) integrate::rk4(x, v, n / 60.0, 1 / 60.0, spring);
/// @endcode
#pragma once
#include <type_traits>

namespace integrate {

#ifdef __clang__
// Else clang does not inline so long a function, and then cannot vectorise a loop over bodies.
template <class Position, class Vec, class Time, class Real, class Acceleration>
[[gnu::always_inline]] constexpr void rk4(Position&, Vec&, Time, Real, Acceleration&&);
#endif

/// One step of the classical Runge-Kutta method.
///
/// Order 4, four evaluations of the acceleration, stable on drag while c*h < 2.785, on an undamped
/// spring while h*omega < 2.828. On poses, order 2.
///
/// @param x  position, advanced in place
/// @param v  velocity, advanced in place
/// @param t  time at the start of the step [s]
/// @param h  step size [s]; a negative step goes back in time
/// @param acceleration  callable `(x, v, t) -> Vec` [units of x per s^2]
/// @see W. Kutta, Beitrag zur naeherungsweisen Integration totaler Differentialgleichungen (1901)
template <class Position, class Vec, class Time, class Real, class Acceleration>
constexpr void rk4(Position& x, Vec& v, Time t, Real h, Acceleration&& acceleration) {
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
    const Clock t_end = Clock(t) + Clock(h);
    // [move]
    const Real half = h / Real(2);
    const Vec a1 = acceleration(x, v, t);
    const Vec v2 = v + half * a1;
    const Vec a2 = acceleration(Position(x + half * v), v2, t_middle);
    const Vec v3 = v + half * a2;
    const Vec a3 = acceleration(Position(x + half * v2), v3, t_middle);
    const Vec v4 = v + h * a3;
    const Vec a4 = acceleration(Position(x + h * v3), v4, t_end);
    x = x + (h / Real(6)) * (v + Real(2) * (v2 + v3) + v4);
    v = v + (h / Real(6)) * (a1 + Real(2) * (a2 + a3) + a4);
    // [move]
  }
}

}  // namespace integrate
