// SPDX-License-Identifier: MIT-0
/// @file
/// Dormand-Prince 5(4): fifth order, with an estimate of its own error.
///
/// @code
/// const auto spring = [](double x, double v, double) { return -9 * x - v; };
/// const double h = 1 / 60.0;
/// double x = 1, v = 0;
/// double a = integrate::dopri5_start(x, v, 0.0, spring);
/// for (int n = 0; n < 60; ++n) integrate::dopri5(x, v, a, n * h, h, spring);
/// @endcode
///
/// To a tolerance, from the same start:
/// @code
/// x = 1, v = 0;
/// double next = 0.1;
/// const auto size = [](double error) { return std::abs(error); };
/// const bool arrived = integrate::dopri5_adaptive(x, v, 0.0, 1.0, next, spring, size, 1e-9);
/// @endcode
#pragma once
#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

namespace integrate {

/// The weights of dopri5, in parts of a step: stage i is at c_i and goes along slope j by a_ij.
/// Stage 7 is the end. It is e_j of each slope away from the end of order 4.
struct Dopri5Weights {
  static constexpr double c2 = 1.0 / 5, a21 = 1.0 / 5;
  static constexpr double c3 = 3.0 / 10, a31 = 3.0 / 40, a32 = 9.0 / 40;
  static constexpr double c4 = 4.0 / 5, a41 = 44.0 / 45, a42 = -56.0 / 15, a43 = 32.0 / 9;
  static constexpr double c5 = 8.0 / 9, a51 = 19372.0 / 6561, a52 = -25360.0 / 2187,
                          a53 = 64448.0 / 6561, a54 = -212.0 / 729;
  static constexpr double c6 = 1, a61 = 9017.0 / 3168, a62 = -355.0 / 33, a63 = 46732.0 / 5247,
                          a64 = 49.0 / 176, a65 = -5103.0 / 18656;
  static constexpr double c7 = 1, a71 = 35.0 / 384, a73 = 500.0 / 1113, a74 = 125.0 / 192,
                          a75 = -2187.0 / 6784, a76 = 11.0 / 84;
  static constexpr double e1 = 71.0 / 57600, e3 = -71.0 / 16695, e4 = 71.0 / 1920,
                          e5 = -17253.0 / 339200, e6 = 22.0 / 525, e7 = -1.0 / 40;
};

/// How far two solutions of dopri5, of order 5 and 4, are apart.
template <class Vec>
struct Dopri5Error {
  Vec x;  ///< in position
  Vec v;  ///< in velocity
};

/// The acceleration at the start, for dopri5 to begin with.
///
/// @param x  position
/// @param v  velocity
/// @param t  time of `x` and `v` [s]
/// @param acceleration  callable `(x, v, t) -> Vec` [units of x per s^2]
template <class Vec, class Time, class Acceleration>
constexpr Vec dopri5_start(const Vec& x, const Vec& v, Time t, Acceleration&& acceleration) {
  constexpr bool calls = std::is_invocable_r_v<Vec, Acceleration&, const Vec&, const Vec&, Time>;
  static_assert(calls, "acceleration must be callable as Vec(x, v, t)");
  if constexpr (calls) return acceleration(x, v, t);
}

/// One step of the method of Dormand and Prince, of order 5, with an estimate of its error.
///
/// Order 5, six evaluations of the acceleration, stable on drag while c*h < 3.306, on an undamped
/// spring while h*omega < 0.997.
///
/// @param x  position, advanced in place
/// @param v  velocity, advanced in place
/// @param a  acceleration at the start, replaced by the one at the end; see dopri5_start
/// @param t  time at the start of the step [s]
/// @param h  step size [s]; a negative step goes back in time
/// @param acceleration  callable `(x, v, t) -> Vec` [units of x per s^2]
/// @returns  the estimate, of order 4: more than the step's own error as long as h is small
/// @see J. R. Dormand and P. J. Prince, A family of embedded Runge-Kutta formulae (1980)
template <class Vec, class Time, class Real, class Acceleration>
constexpr Dopri5Error<Vec> dopri5(Vec& x, Vec& v, Vec& a, Time t, Real h,
                                  Acceleration&& acceleration) {
  constexpr bool calls = std::is_invocable_r_v<Vec, Acceleration&, const Vec&, const Vec&, Time>;
  constexpr auto scale = [](auto s, const auto& y) -> decltype(s * y) { return s * y; };
  constexpr bool scales = std::is_invocable_r_v<Vec, decltype(scale), Real, Vec>;
  static_assert(calls, "acceleration must be callable as Vec(x, v, t)");
  static_assert(scales, "h * x must be a Vec");
  static_assert(!std::is_integral_v<Real>, "h must be no integer");
  if constexpr (calls && scales) {
    // [move]
    using W = Dopri5Weights;
    const auto part = [h](double weight) { return h * Real(weight); };
    const Vec x2 = x + part(W::a21) * v;
    const Vec v2 = v + part(W::a21) * a;
    const Vec a2 = acceleration(x2, v2, t + part(W::c2));
    const Vec x3 = x + (part(W::a31) * v + part(W::a32) * v2);
    const Vec v3 = v + (part(W::a31) * a + part(W::a32) * a2);
    const Vec a3 = acceleration(x3, v3, t + part(W::c3));
    const Vec x4 = x + (part(W::a41) * v + part(W::a42) * v2 + part(W::a43) * v3);
    const Vec v4 = v + (part(W::a41) * a + part(W::a42) * a2 + part(W::a43) * a3);
    const Vec a4 = acceleration(x4, v4, t + part(W::c4));
    const Vec x5 =
        x + (part(W::a51) * v + part(W::a52) * v2 + part(W::a53) * v3 + part(W::a54) * v4);
    const Vec v5 =
        v + (part(W::a51) * a + part(W::a52) * a2 + part(W::a53) * a3 + part(W::a54) * a4);
    const Vec a5 = acceleration(x5, v5, t + part(W::c5));
    const Vec x6 = x + (part(W::a61) * v + part(W::a62) * v2 + part(W::a63) * v3 +
                        part(W::a64) * v4 + part(W::a65) * v5);
    const Vec v6 = v + (part(W::a61) * a + part(W::a62) * a2 + part(W::a63) * a3 +
                        part(W::a64) * a4 + part(W::a65) * a5);
    const Vec a6 = acceleration(x6, v6, t + part(W::c6));
    const Vec x7 = x + (part(W::a71) * v + part(W::a73) * v3 + part(W::a74) * v4 +
                        part(W::a75) * v5 + part(W::a76) * v6);
    const Vec v7 = v + (part(W::a71) * a + part(W::a73) * a3 + part(W::a74) * a4 +
                        part(W::a75) * a5 + part(W::a76) * a6);
    const Vec a7 = acceleration(x7, v7, t + part(W::c7));
    // Two sums of their own, since clang++ -O3 would pack one of both into every stage.
    const Vec x_error = part(W::e1) * v + part(W::e3) * v3 + part(W::e4) * v4 + part(W::e5) * v5 +
                        part(W::e6) * v6 + part(W::e7) * v7;
    const Vec v_error = part(W::e1) * a + part(W::e3) * a3 + part(W::e4) * a4 + part(W::e5) * a5 +
                        part(W::e6) * a6 + part(W::e7) * a7;
    x = x7;
    v = v7;
    a = a7;
    return {x_error, v_error};
    // [move]
  }
}

/// Moves on by `duration` in as many steps of dopri5 as a tolerance asks for.
///
/// For answers to compare with. In a frame it is the wrong tool: nobody knows what it will cost.
///
/// @param x  position, advanced in place
/// @param v  velocity, advanced in place
/// @param t  time at the start [s]
/// @param duration  how far to go [s]; a negative one goes back in time
/// @param h  size of the first step to try, above zero; replaced by the size to try next [s]
/// @param acceleration  callable `(x, v, t) -> Vec` [units of x per s^2]
/// @param norm  callable `(Vec) -> Real`, the size of an error in `x` or in `v`
/// @param tolerance  largest size of the estimate in one step
/// @returns  whether it got there; if not, the step had to shrink to nothing, or the acceleration
/// or the duration was not finite, and x and v are as at the start
/// @see Hairer, Norsett and Wanner, Solving Ordinary Differential Equations I (1993), section II.4
template <class Vec, class Time, class Real, class Acceleration, class Norm>
[[nodiscard]] bool dopri5_adaptive(Vec& x, Vec& v, Time t, Real duration, Real& h,
                                   Acceleration&& acceleration, Norm&& norm, Real tolerance) {
  constexpr bool calls = std::is_invocable_r_v<Vec, Acceleration&, const Vec&, const Vec&, Time>;
  constexpr auto scale = [](auto s, const auto& y) -> decltype(s * y) { return s * y; };
  constexpr bool scales = std::is_invocable_r_v<Vec, decltype(scale), Real, Vec>;
  static_assert(calls, "acceleration must be callable as Vec(x, v, t)");
  static_assert(scales, "h * x must be a Vec");
  static_assert(!std::is_integral_v<Real>, "h must be no integer");
  constexpr bool measures = std::is_invocable_r_v<Real, Norm&, const Vec&>;
  static_assert(measures, "norm must be callable as Real(Vec)");
  if constexpr (calls && scales && measures) {
    // By an integer, since -ffast-math takes every comparison for one of finite numbers.
    const auto finite = [](Real size) {
      const int exponent = std::ilogb(Real(1) + size);
      return exponent >= 0 && exponent < (std::numeric_limits<int>::max)();
    };
    const Real length = std::abs(duration);
    if (!finite(length)) return false;
    const Real forward = duration < Real(0) ? Real(-1) : Real(1);
    Vec x_now = x, v_now = v, a_now = dopri5_start(x, v, t, acceleration);
    for (Real done = 0; done < length;) {
      const bool last = !(h < length - done);
      const Real step = last ? length - done : h;
      if (!(done + step > done)) return false;
      Vec x_next = x_now, v_next = v_now, a_next = a_now;
      const auto error =
          dopri5(x_next, v_next, a_next, t + forward * done, forward * step, acceleration);
      const Real in_v = Real(norm(error.v)) / tolerance, in_x = Real(norm(error.x)) / tolerance;
      const bool known = finite(in_v) && finite(in_x);
      const Real size = (std::max)(in_v, in_x);
      const bool good = known && size <= Real(1);
      const Real wish = size > Real(0) ? Real(0.9) * std::pow(size, Real(-0.2)) : Real(5);
      const Real change = known ? std::clamp(wish, Real(0.2), Real(5)) : Real(0.2);
      if (!(good && last)) h = step * change;
      if (!good) continue;
      x_now = x_next, v_now = v_next, a_now = a_next;
      done = last ? length : done + step;
    }
    x = x_now, v = v_now;
    return true;
  }
}

}  // namespace integrate
