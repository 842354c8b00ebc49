// SPDX-License-Identifier: MIT-0
/// @file
/// Backward Euler, or implicit Euler, by a linear system: one solve, or Newton's method.
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
///   solved = integrate::backward_euler(x, v, n * h, h, spring, solve);
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
///   iterations = integrate::backward_euler_newton(x, v, n * h, h, spring, solve, size, 1e-9);
/// }
/// @endcode
#pragma once
#include <type_traits>

namespace integrate {

/// One step of backward (implicit) Euler with a single solve: linearly implicit Euler.
///
/// Order 1, one evaluation of the acceleration and one solve, stable on drag for every h, on an
/// undamped spring for every h. On a linear force it is implicit Euler itself. On any other it puts
/// a tangent in the force's place: the one at x + h*v, where Newton's method begins. Baraff and
/// Witkin take the one at x, and their steps are different there.
///
/// @param x  position, advanced in place
/// @param v  velocity, advanced in place
/// @param t  time at the start of the step [s]
/// @param h  step size [s]; not negative
/// @param acceleration  callable `(x, v, t) -> Vec` [units of x per s^2]
/// @param solve  callable `(x, v, t, p, q, change) -> bool`: solves (1 + p da/dx + q da/dv) y =
/// change and puts y into `change`; false if it could not. For a single unknown that is
/// `change = change / (1 + p * dadx + q * dadv)`; for more there are DenseSystem, BandSystem and
/// SparseSystem
/// @returns  false if the system could not be solved; x and v are then as they were
/// @see D. Baraff and A. Witkin, Large steps in cloth simulation, SIGGRAPH (1998)
template <class Vec, class Time, class Real, class Acceleration, class Solve>
[[nodiscard]] constexpr bool backward_euler(Vec& x, Vec& v, Time t, Real h,
                                            Acceleration&& acceleration, Solve&& solve) {
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
    const Vec x_end = x + h * v;
    Vec change = h * acceleration(x_end, v, t_end);
    if (!solve(x_end, v, t_end, -h * h, -h, change)) return false;
    v = v + change;
    x = x + h * v;
    return true;
    // [move]
  }
}

/// One step of backward (implicit) Euler, solved by Newton's method to a tolerance.
///
/// Order 1, one evaluation of the acceleration and one solve for each iteration, stable on drag for
/// every h, on an undamped spring for every h.
///
/// @param x  position, advanced in place
/// @param v  velocity, advanced in place
/// @param t  time at the start of the step [s]
/// @param h  step size [s]; not negative
/// @param acceleration  callable `(x, v, t) -> Vec` [units of x per s^2]
/// @param solve  as for backward_euler
/// @param norm  callable `(Vec) -> Real`, the size of a change of velocity
/// @param tolerance  the iteration ends when the velocity changes by no more [units of x per s]
/// @returns  how many iterations it took; 0 if it found no end within 50 or a system could not be
/// solved, and x and v are then as they were
/// @see Hairer and Wanner, Solving Ordinary Differential Equations II (1996), section IV.8
template <class Vec, class Time, class Real, class Acceleration, class Solve, class Norm>
[[nodiscard]] constexpr int backward_euler_newton(Vec& x, Vec& v, Time t, Real h,
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
    // [newton-move]
    Vec v_end = v;
    for (int iteration = 1; iteration <= 50; ++iteration) {
      const Vec x_end = x + h * v_end;
      Vec change = v + Real(-1) * v_end + h * acceleration(x_end, v_end, t_end);
      if (!solve(x_end, v_end, t_end, -h * h, -h, change)) return 0;
      v_end = v_end + change;
      if (norm(change) <= tolerance) {
        v = v_end;
        x = x + h * v;
        return iteration;
      }
    }
    return 0;
    // [newton-move]
  }
}

}  // namespace integrate
