// SPDX-License-Identifier: MIT-0
/// @file
/// Yoshida 4: fourth order from three steps of velocity Verlet.
///
/// @code
/// const auto spring = [](double x, double v, double) { return -9 * x - v; };
/// const double h = 1 / 60.0;
/// double x = 1, v = 0;
/// double a = integrate::yoshida4_start(x, v, 0.0, spring);
/// for (int n = 0; n < 60; ++n) integrate::yoshida4(x, v, a, n * h, h, spring);
/// @endcode
#pragma once
#include <type_traits>

namespace integrate {

/// The acceleration at the start, for yoshida4 to begin with.
///
/// @param x  position
/// @param v  velocity
/// @param t  time of `x` and `v` [s]
/// @param acceleration  callable `(x, v, t) -> Vec` [units of x per s^2]
template <class Position, class Vec, class Time, class Acceleration>
constexpr Vec yoshida4_start(const Position& x, const Vec& v, Time t, Acceleration&& acceleration) {
  constexpr bool calls =
      std::is_invocable_r_v<Vec, Acceleration&, const Position&, const Vec&, Time>;
  static_assert(calls, "acceleration must be callable as Vec(x, v, t)");
  if constexpr (calls) return acceleration(x, v, t);
}

#ifdef __clang__
// Else clang does not inline so long a function, and then cannot vectorise a loop over bodies.
template <class Position, class Vec, class Time, class Real, class Acceleration>
[[gnu::always_inline]] constexpr void yoshida4(Position&, Vec&, Vec&, Time, Real, Acceleration&&);
#endif

/// One step of Yoshida's method: velocity Verlet forward, backward and forward again.
///
/// Order 4, 2 under drag, three evaluations of the acceleration, stable on drag while c*h < 0.912,
/// on an undamped spring while h*omega < 1.573. On poses, order 4.
///
/// @param x  position, advanced in place
/// @param v  velocity, advanced in place
/// @param a  acceleration at the start, replaced by the one at the end; see yoshida4_start
/// @param t  time at the start of the step [s]
/// @param h  step size [s]; a negative step goes back in time
/// @param acceleration  callable `(x, v, t) -> Vec` [units of x per s^2]
/// @see H. Yoshida, Construction of higher order symplectic integrators, Physics Letters A 150
/// (1990)
template <class Position, class Vec, class Time, class Real, class Acceleration>
constexpr void yoshida4(Position& x, Vec& v, Vec& a, Time t, Real h, Acceleration&& acceleration) {
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
    const auto after = [t](Real past) { return Clock(t) + Clock(past); };
    // [move]
    const Real outer = h * Real(1.3512071919596576340476878089715);  // h / (2 - cbrt(2))
    const Real middle = h - Real(2) * outer;                         // a step back
    const auto verlet = [&](Real part, auto end) {
      const Vec v_half = v + (part / Real(2)) * a;
      const Vec v_predicted = v + part * a;
      x = x + part * v_half;
      a = acceleration(x, v_predicted, end);
      v = v_half + (part / Real(2)) * a;
    };
    verlet(outer, after(outer));
    verlet(middle, after(outer + middle));
    verlet(outer, after(h));
    // [move]
  }
}

}  // namespace integrate
