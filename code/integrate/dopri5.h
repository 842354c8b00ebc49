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

/// The weights of dopri5: each row makes a stage of the slopes before it. The last stage but one is
/// the new state; the last row is what it differs by from a solution of order 4.
inline constexpr double dopri5_weights[7][7] = {
    {1.0 / 5},
    {3.0 / 40, 9.0 / 40},
    {44.0 / 45, -56.0 / 15, 32.0 / 9},
    {19372.0 / 6561, -25360.0 / 2187, 64448.0 / 6561, -212.0 / 729},
    {9017.0 / 3168, -355.0 / 33, 46732.0 / 5247, 49.0 / 176, -5103.0 / 18656},
    {35.0 / 384, 0, 500.0 / 1113, 125.0 / 192, -2187.0 / 6784, 11.0 / 84},
    {71.0 / 57600, 0, -71.0 / 16695, 71.0 / 1920, -17253.0 / 339200, 22.0 / 525, -1.0 / 40}};

/// When the stages of dopri5 are evaluated, in parts of the step.
inline constexpr double dopri5_times[6] = {1.0 / 5, 3.0 / 10, 4.0 / 5, 8.0 / 9, 1, 1};

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
    Vec velocities[7] = {v, v, v, v, v, v, v};
    Vec accelerations[7] = {a, a, a, a, a, a, a};
    const auto sum = [h](const Vec* slopes, int row) {
      Vec total = (h * Real(dopri5_weights[row][0])) * slopes[0];
      for (int n = 1; n <= row; ++n) total = total + (h * Real(dopri5_weights[row][n])) * slopes[n];
      return total;
    };
    Vec x_end = x;
    for (int stage = 1; stage < 7; ++stage) {
      x_end = x + sum(velocities, stage - 1);
      velocities[stage] = v + sum(accelerations, stage - 1);
      accelerations[stage] =
          acceleration(x_end, velocities[stage], t + h * Real(dopri5_times[stage - 1]));
    }
    x = x_end;
    v = velocities[6];
    a = accelerations[6];
    return {sum(velocities, 6), sum(accelerations, 6)};
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
