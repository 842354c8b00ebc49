// SPDX-License-Identifier: MIT-0
/// @file
/// The trapezoid rule: the implicit method of second order.
///
/// @code
/// const auto spring = [](double x, double v, double) { return -9 * x - v; };
/// const auto solve = [](double, double, double, double p, double q, double& change) {
///   change = change / (1 + p * -9 + q * -1);  // da/dx is -9, da/dv is -1
///   return true;
/// };
/// const double h = 1 / 60.0;
/// double x = 1, v = 0;
/// bool solved = true;
/// for (int n = 0; n < 60 && solved; ++n) {
///   solved = integrate::trapezoid(x, v, n * h, h, spring, solve);
/// }
/// @endcode
///
/// To a tolerance, from the same start:
/// @code
/// #include <cmath>
///
/// x = 1, v = 0;
/// const auto size = [](double change) { return std::abs(change); };
/// int iterations = 1;
/// for (int n = 0; n < 60 && iterations > 0; ++n) {
///   iterations = integrate::trapezoid_newton(x, v, n * h, h, spring, solve, size, 1e-9);
/// }
/// @endcode
#pragma once
#include <type_traits>

namespace integrate {

/// One step of the trapezoid rule with a single solve.
///
/// Order 2, two evaluations of the acceleration and one solve, stable on drag for every h, on an
/// undamped spring for every h. On a linear force it is the trapezoid rule itself; on another it
/// has no such promise, and a rope that swings explodes: take backward_euler for ropes and cloth.
///
/// @param x  position, advanced in place
/// @param v  velocity, advanced in place
/// @param t  time at the start of the step [s]
/// @param h  step size [s]; a negative step goes back in time, on drag while c*|h| < 2
/// @param acceleration  callable `(x, v, t) -> Vec` [units of x per s^2]
/// @param solve  callable `(x, v, t, p, q, change) -> bool`: solves (1 + p da/dx + q da/dv) y =
/// change and puts y into `change`; false if it could not. For a single unknown that is
/// `change = change / (1 + p * dadx + q * dadv)`; for more there are DenseSystem, BandSystem and
/// SparseSystem
/// @returns  false if the system could not be solved; x and v are then as they were
/// @see G. Dahlquist, A special stability problem for linear multistep methods, BIT 3 (1963)
template <class Vec, class Time, class Real, class Acceleration, class Solve>
[[nodiscard]] constexpr bool trapezoid(Vec& x, Vec& v, Time t, Real h, Acceleration&& acceleration,
                                       Solve&& solve) {
  constexpr bool calls = std::is_invocable_r_v<Vec, Acceleration&, const Vec&, const Vec&, Time>;
  constexpr auto scale = [](auto s, const auto& y) -> decltype(s * y) { return s * y; };
  constexpr bool scales = std::is_invocable_r_v<Vec, decltype(scale), Real, Vec>;
  static_assert(calls, "acceleration must be callable as Vec(x, v, t)");
  static_assert(scales,
                "h * x must be a Vec: 1/60.0f for floats; copy Maps; raylib lacks float * Vector3");
  static_assert(!std::is_integral_v<Real>, "h must be no integer");
  constexpr bool solves =
      std::is_invocable_r_v<bool, Solve&, const Vec&, const Vec&, Time, Real, Real, Vec&>;
  static_assert(solves, "solve must be callable as bool(x, v, t, p, q, change), change a Vec&");
  if constexpr (calls && scales && solves) {
    using Clock = std::common_type_t<Time, Real>;  // for -Wdouble-promotion
    const Clock t_end = Clock(t) + Clock(h);
    // [move]
    const Real half = h / Real(2);
    const Vec x_end = x + h * v;
    const Vec a = acceleration(x, v, t);
    Vec change = half * Vec(a + acceleration(x_end, v, t_end));
    if (!solve(x_end, v, t_end, -half * half, -half, change)) return false;
    x = x + h * v + half * change;
    v = v + change;
    return true;
    // [move]
  }
}

/// One step of the trapezoid rule, solved by Newton's method to a tolerance.
///
/// Order 2, one evaluation of the acceleration, and one more with a solve for each iteration,
/// stable on drag for every h, on an undamped spring for every h.
///
/// @param x  position, advanced in place
/// @param v  velocity, advanced in place
/// @param t  time at the start of the step [s]
/// @param h  step size [s]; a negative step goes back in time, on drag while c*|h| < 2
/// @param acceleration  callable `(x, v, t) -> Vec` [units of x per s^2]
/// @param solve  as for trapezoid
/// @param norm  callable `(Vec) -> Real`, the size of a change of velocity
/// @param tolerance  the iteration ends when the velocity changes by no more [units of x per s]
/// @returns  how many iterations it took; 0 if it found no end within 50 or a system could not be
/// solved, and x and v are then as they were
/// @see Hairer and Wanner, Solving Ordinary Differential Equations II (1996), section IV.8
template <class Vec, class Time, class Real, class Acceleration, class Solve, class Norm>
[[nodiscard]] constexpr int trapezoid_newton(Vec& x, Vec& v, Time t, Real h,
                                             Acceleration&& acceleration, Solve&& solve,
                                             Norm&& norm, Real tolerance) {
  constexpr bool calls = std::is_invocable_r_v<Vec, Acceleration&, const Vec&, const Vec&, Time>;
  constexpr auto scale = [](auto s, const auto& y) -> decltype(s * y) { return s * y; };
  constexpr bool scales = std::is_invocable_r_v<Vec, decltype(scale), Real, Vec>;
  static_assert(calls, "acceleration must be callable as Vec(x, v, t)");
  static_assert(scales,
                "h * x must be a Vec: 1/60.0f for floats; copy Maps; raylib lacks float * Vector3");
  static_assert(!std::is_integral_v<Real>, "h must be no integer");
  constexpr bool solves =
      std::is_invocable_r_v<bool, Solve&, const Vec&, const Vec&, Time, Real, Real, Vec&>;
  static_assert(solves, "solve must be callable as bool(x, v, t, p, q, change), change a Vec&");
  constexpr bool measures = std::is_invocable_r_v<Real, Norm&, const Vec&>;
  static_assert(measures, "norm must be callable as Real(Vec)");
  if constexpr (calls && scales && solves && measures) {
    using Clock = std::common_type_t<Time, Real>;  // for -Wdouble-promotion
    const Clock t_end = Clock(t) + Clock(h);
    const Real half = h / Real(2);
    const Vec a = acceleration(x, v, t);
    Vec v_end = v;
    for (int iteration = 1; iteration <= 50; ++iteration) {
      const Vec x_end = x + half * Vec(v + v_end);
      const Vec a_end = acceleration(x_end, v_end, t_end);
      Vec change = v + Real(-1) * v_end + half * Vec(a + a_end);
      if (!solve(x_end, v_end, t_end, -half * half, -half, change)) return 0;
      v_end = v_end + change;
      if (norm(change) <= tolerance) {
        x = x + half * Vec(v + v_end);
        v = v_end;
        return iteration;
      }
    }
    return 0;
  }
}

}  // namespace integrate
