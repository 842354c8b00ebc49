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
///
/// In frames, none of which cuts a step short:
/// @code
/// auto path = integrate::dopri5_path(1.0, 0.0, 0.0, 0.1, spring);
/// for (int frame = 1; frame <= 60; ++frame) {
///   if (!integrate::dopri5_adaptive(path, frame / 60.0, spring, size, 1e-9)) break;
///   x = path.position(frame / 60.0), v = path.velocity(frame / 60.0);
/// }
/// @endcode
#pragma once
#include <cmath>
#include <limits>
#include <type_traits>

namespace integrate {

// Checks that a path of dopri5 can use these types; what one lacks is a compile error that says
// so.
template <class Vec, class Time, class Real, class Acceleration>
constexpr bool dopri5_accepts() {
  constexpr bool calls = std::is_invocable_r_v<Vec, Acceleration&, const Vec&, const Vec&, Time>;
  constexpr auto scale = [](auto s, const auto& y) -> decltype(s * y) { return s * y; };
  constexpr bool scales = std::is_invocable_r_v<Vec, decltype(scale), Real, Vec>;
  static_assert(calls, "acceleration must be callable as Vec(x, v, t)");
  static_assert(!calls || scales,
                "h * x must be a Vec: 1/60.0f for floats; copy Maps; raylib lacks float * Vector3");
  static_assert(!std::is_integral_v<Real>, "h must be no integer");
  return calls && scales && !std::is_integral_v<Real>;
}

/// The weights of dopri5, in parts of a step: stage i is at c_i and goes along slope j by a_ij.
/// Stage 7 is the end. It is e_j of each slope away from the end of order 4, and d_j of each bends
/// the way there.
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
  static constexpr double d1 = -12715105075.0 / 11282082432, d3 = 87487479700.0 / 32700410799,
                          d4 = -10690763975.0 / 1880347072, d5 = 701980252875.0 / 199316789632,
                          d6 = -1453857185.0 / 822651844, d7 = 69997945.0 / 29380423;
};

/// How far two solutions of dopri5, of order 5 and 4, are apart.
template <class Vec>
struct Dopri5Error {
  Vec x;  ///< in position
  Vec v;  ///< in velocity
};

/// Where dopri5 has got to, and its last step, to be read at any time within. See dopri5_path.
template <class Vec, class Time, class Real>
struct Dopri5Path {
  Vec x;          ///< position
  Vec v;          ///< velocity
  Vec a;          ///< acceleration
  Time t;         ///< time of these [s]
  Real h;         ///< size of the step to try next, above zero [s]
  Vec x_before;   ///< position at the start of the last step
  Vec v_before;   ///< velocity there
  Vec a_before;   ///< acceleration there
  Time t_before;  ///< time of these [s]
  Real length;    ///< of the last step, negative if it went back in time [s]
  Vec x_bend;     ///< how the positions of the last step bend away from a cubic
  Vec v_bend;     ///< the same of the velocities

  /// True of a time in the last step. The path can be asked of no other.
  constexpr bool holds(Time at) const {
    return (t_before <= at && at <= t) || (t <= at && at <= t_before);
  }

  /// Position at a time in the last step, wrong by a term in h^5 where the step's end is by h^6.
  constexpr Vec position(Time at) const { return between(at, x_before, v_before, x, v, x_bend); }

  /// Velocity at a time in the last step, as good as the position.
  constexpr Vec velocity(Time at) const { return between(at, v_before, a_before, v, a, v_bend); }

 private:
  // The cubic through both ends along their slopes, and a bend that is nothing at either end.
  constexpr Vec between(Time at, const Vec& start, const Vec& slope_there, const Vec& end,
                        const Vec& slope_here, const Vec& bend) const {
    const Real past = Real(at - t_before) / length, left = Real(1) - past;
    return start + ((past * past * (Real(3) - Real(2) * past)) * (end + Real(-1) * start) +
                    (length * past * left * left) * slope_there +
                    (Real(-1) * length * past * past * left) * slope_here +
                    (past * past * left * left) * bend);
  }
};

/// The verdict of an estimate on its step, and on the size of the next.
template <class Real>
struct Dopri5Verdict {
  bool good = false;        ///< whether the step is within the tolerance
  Real change = Real(0.2);  ///< what to multiply its size by

  /// @param in_x  size of the estimate in position, over the tolerance
  /// @param in_v  the same in velocity
  Dopri5Verdict(Real in_x, Real in_v) {
    if (!finite(in_x) || !finite(in_v)) return;
    // [rule]
    const Real size = in_v < in_x ? in_x : in_v;
    const Real wish = size > Real(0) ? Real(0.9) * std::pow(size, Real(-0.2)) : Real(5);
    good = size <= Real(1);
    change = wish < Real(0.2) ? Real(0.2) : wish > Real(5) ? Real(5) : wish;
    // [rule]
  }

  /// By an integer, since -ffast-math takes every comparison for one of finite numbers.
  static bool finite(Real size) {
    const int exponent = std::ilogb(Real(1) + size);
    return exponent >= 0 && exponent < (std::numeric_limits<int>::max)();
  }
};

/// The acceleration at the start, for dopri5 to begin with.
///
/// @param x  position
/// @param v  velocity
/// @param t  time of `x` and `v` [s]
/// @param acceleration  callable `(x, v, t) -> Vec` [units of x per s^2]
template <class Position, class Vec, class Time, class Acceleration>
constexpr Vec dopri5_start(const Position& x, const Vec& v, Time t, Acceleration&& acceleration) {
  constexpr bool calls =
      std::is_invocable_r_v<Vec, Acceleration&, const Position&, const Vec&, Time>;
  static_assert(calls, "acceleration must be callable as Vec(x, v, t)");
  if constexpr (calls) return acceleration(x, v, t);
}

#ifdef __clang__
// Else clang does not inline so long a function, and then cannot vectorise a loop over bodies.
template <class Position, class Vec, class Time, class Real, class Acceleration>
[[gnu::always_inline]] constexpr Dopri5Error<Vec> dopri5(Position&, Vec&, Vec&, Time, Real,
                                                         Acceleration&&);
#endif

/// One step of the method of Dormand and Prince, of order 5, with an estimate of its error.
///
/// Order 5, six evaluations of the acceleration, stable on drag while c*h < 3.306, on an undamped
/// spring while h*omega < 0.997. On poses, order 2.
///
/// @param x  position, advanced in place
/// @param v  velocity, advanced in place
/// @param a  acceleration at the start, replaced by the one at the end; see dopri5_start
/// @param t  time at the start of the step [s]
/// @param h  step size [s]; a negative step goes back in time
/// @param acceleration  callable `(x, v, t) -> Vec` [units of x per s^2]
/// @returns  the estimate, of order 4: more than the step's own error as long as h is small
/// @see J. R. Dormand and P. J. Prince, A family of embedded Runge-Kutta formulae (1980)
template <class Position, class Vec, class Time, class Real, class Acceleration>
constexpr Dopri5Error<Vec> dopri5(Position& x, Vec& v, Vec& a, Time t, Real h,
                                  Acceleration&& acceleration) {
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
    const auto at = [t, h](double weight) { return Clock(t) + Clock(h * Real(weight)); };
    // [move]
    using W = Dopri5Weights;
    const auto part = [h](double weight) { return h * Real(weight); };
    const Position x2 = x + part(W::a21) * v;
    const Vec v2 = v + part(W::a21) * a;
    const Vec a2 = acceleration(x2, v2, at(W::c2));
    const Position x3 = x + (part(W::a31) * v + part(W::a32) * v2);
    const Vec v3 = v + (part(W::a31) * a + part(W::a32) * a2);
    const Vec a3 = acceleration(x3, v3, at(W::c3));
    const Position x4 = x + (part(W::a41) * v + part(W::a42) * v2 + part(W::a43) * v3);
    const Vec v4 = v + (part(W::a41) * a + part(W::a42) * a2 + part(W::a43) * a3);
    const Vec a4 = acceleration(x4, v4, at(W::c4));
    const Position x5 =
        x + (part(W::a51) * v + part(W::a52) * v2 + part(W::a53) * v3 + part(W::a54) * v4);
    const Vec v5 =
        v + (part(W::a51) * a + part(W::a52) * a2 + part(W::a53) * a3 + part(W::a54) * a4);
    const Vec a5 = acceleration(x5, v5, at(W::c5));
    const Position x6 = x + (part(W::a61) * v + part(W::a62) * v2 + part(W::a63) * v3 +
                             part(W::a64) * v4 + part(W::a65) * v5);
    const Vec v6 = v + (part(W::a61) * a + part(W::a62) * a2 + part(W::a63) * a3 +
                        part(W::a64) * a4 + part(W::a65) * a5);
    const Vec a6 = acceleration(x6, v6, at(W::c6));
    const Position x7 = x + (part(W::a71) * v + part(W::a73) * v3 + part(W::a74) * v4 +
                             part(W::a75) * v5 + part(W::a76) * v6);
    const Vec v7 = v + (part(W::a71) * a + part(W::a73) * a3 + part(W::a74) * a4 +
                        part(W::a75) * a5 + part(W::a76) * a6);
    const Vec a7 = acceleration(x7, v7, at(W::c7));
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

/// A path of dopri5 at its start, to be read there and to go on from.
///
/// @param x  position
/// @param v  velocity
/// @param t  time of `x` and `v` [s]
/// @param h  size of the first step to try, above zero [s]
/// @param acceleration  callable `(x, v, t) -> Vec` [units of x per s^2]
template <class Vec, class Time, class Real, class Acceleration>
constexpr Dopri5Path<Vec, Time, Real> dopri5_path(const Vec& x, const Vec& v, Time t, Real h,
                                                  Acceleration&& acceleration) {
  static_assert(!std::is_integral_v<Time>, "t must be no integer, since the path keeps its type");
  if constexpr (dopri5_accepts<Vec, Time, Real, Acceleration>()) {
    const Vec a = acceleration(x, v, t);
    return {x, v, a, t, h, x, v, a, t, h, Real(0) * x, Real(0) * v};
  }
}

/// One step of dopri5 along a path, which then holds the times of this step.
///
/// @param path  advanced in place, but for the size of the step to try next
/// @param h  step size [s]; a negative step goes back in time
/// @param acceleration  callable `(x, v, t) -> Vec` [units of x per s^2]
/// @returns  the estimate of the other dopri5, whose step this is
/// @see Hairer, Norsett and Wanner, Solving Ordinary Differential Equations I (1993), section II.6
template <class Vec, class Time, class Real, class Acceleration>
constexpr Dopri5Error<Vec> dopri5(Dopri5Path<Vec, Time, Real>& path, Real h,
                                  Acceleration&& acceleration) {
  if constexpr (dopri5_accepts<Vec, Time, Real, Acceleration>()) {
    using Clock = std::common_type_t<Time, Real>;  // for -Wdouble-promotion
    Vec v[7] = {path.v, path.v, path.v, path.v, path.v, path.v, path.v};
    Vec a[7] = {path.a, path.a, path.a, path.a, path.a, path.a, path.a};
    int stage = 0;
    const auto noting = [&](const Vec& x_stage, const Vec& v_stage, Time t_stage) {
      ++stage;
      v[stage] = v_stage;
      return Vec(a[stage] = acceleration(x_stage, v_stage, t_stage));
    };
    const auto bend = [h](const Vec* slopes) {
      using W = Dopri5Weights;
      return Vec((h * Real(W::d1)) * slopes[0] + (h * Real(W::d3)) * slopes[2] +
                 (h * Real(W::d4)) * slopes[3] + (h * Real(W::d5)) * slopes[4] +
                 (h * Real(W::d6)) * slopes[5] + (h * Real(W::d7)) * slopes[6]);
    };
    path.x_before = path.x, path.v_before = path.v, path.a_before = path.a;
    path.t_before = path.t, path.length = h;
    const Dopri5Error<Vec> error = dopri5(path.x, path.v, path.a, path.t, h, noting);
    path.t = Time(Clock(path.t) + Clock(h));
    path.x_bend = bend(v), path.v_bend = bend(a);
    return error;
  }
}

/// Moves on by `duration` in as many steps of dopri5 as a tolerance asks for.
///
/// For answers to compare with. In a frame nobody knows what it will cost, unless `most` says so.
///
/// @param x  position, advanced in place
/// @param v  velocity, advanced in place
/// @param t  time at the start [s]
/// @param duration  how far to go [s]; a negative one goes back in time
/// @param h  size of the first step to try, above zero; replaced by the size to try next [s]
/// @param acceleration  callable `(x, v, t) -> Vec` [units of x per s^2]
/// @param norm  callable `(Vec) -> Real`, the size of an error in `x` or in `v`
/// @param tolerance  largest size of the estimate in one step
/// @param most  how many steps it may try, each of six evaluations
/// @returns  whether it got there; if not, the step had to shrink to nothing, `most` steps were not
/// enough, or the acceleration or the duration was not finite, and x and v are as at the start
/// @see Hairer, Norsett and Wanner, Solving Ordinary Differential Equations I (1993), section II.4
template <class Vec, class Time, class Real, class Acceleration, class Norm>
[[nodiscard]] bool dopri5_adaptive(Vec& x, Vec& v, Time t, Real duration, Real& h,
                                   Acceleration&& acceleration, Norm&& norm, Real tolerance,
                                   long long most = 1'000'000) {
  constexpr bool measures = std::is_invocable_r_v<Real, Norm&, const Vec&>;
  static_assert(measures, "norm must be callable as Real(Vec)");
  if constexpr (dopri5_accepts<Vec, Time, Real, Acceleration>() && measures) {
    using Clock = std::common_type_t<Time, Real>;  // for -Wdouble-promotion
    using Verdict = Dopri5Verdict<Real>;
    const Real length = std::abs(duration);
    if (!Verdict::finite(length)) return false;
    const Real forward = duration < Real(0) ? Real(-1) : Real(1);
    Vec x_now = x, v_now = v, a_now = dopri5_start(x, v, t, acceleration);
    for (Real done = 0; done < length;) {
      const bool last = !(h < length - done);
      const Real step = last ? length - done : h;
      if (!(done + step > done) || most-- <= 0) return false;
      Vec x_next = x_now, v_next = v_now, a_next = a_now;
      const Clock now = Clock(t) + Clock(forward * done);
      const auto error = dopri5(x_next, v_next, a_next, now, forward * step, acceleration);
      const Verdict verdict(Real(norm(error.x)) / tolerance, Real(norm(error.v)) / tolerance);
      if (!(verdict.good && last)) h = step * verdict.change;
      if (!verdict.good) continue;
      x_now = x_next, v_now = v_next, a_now = a_next;
      done = last ? length : done + step;
    }
    x = x_now, v = v_now;
    return true;
  }
}

/// Takes steps along a path until it holds a time, as many as a tolerance asks for.
///
/// No step is cut short, and none depends on which times are asked for: read in frames of any
/// length, the path and what it costs are the same. What else is to change the motion, such as an
/// impulse, begins a new path.
///
/// @param path  advanced in place; its h is replaced by the size to try next
/// @param t  time to get to [s]; one that lies before the last step is gone back to
/// @param acceleration  callable `(x, v, t) -> Vec` [units of x per s^2]
/// @param norm  callable `(Vec) -> Real`, the size of an error in `x` or in `v`
/// @param tolerance  largest size of the estimate in one step
/// @param most  how many steps it may try, each of six evaluations
/// @returns  whether the path holds t; if not, it ends where the step had to shrink to nothing,
/// where `most` steps had got it, or where the acceleration or t was not finite
template <class Vec, class Time, class Real, class Acceleration, class Norm>
[[nodiscard]] bool dopri5_adaptive(Dopri5Path<Vec, Time, Real>& path, Time t,
                                   Acceleration&& acceleration, Norm&& norm, Real tolerance,
                                   long long most = 1'000'000) {
  constexpr bool measures = std::is_invocable_r_v<Real, Norm&, const Vec&>;
  static_assert(measures, "norm must be callable as Real(Vec)");
  if constexpr (dopri5_accepts<Vec, Time, Real, Acceleration>() && measures) {
    using Verdict = Dopri5Verdict<Real>;
    if (!Verdict::finite(std::abs(Real(t - path.t)))) return false;
    while (!path.holds(t)) {
      // As a share of the time, since -ffast-math takes (t + h) - t for h.
      const Real least = Real(std::numeric_limits<Time>::epsilon()) * std::abs(Real(path.t));
      if (!Verdict::finite(path.h) || !(path.h > least) || most-- <= 0) return false;
      auto next = path;
      const auto error = dopri5(next, t < path.t ? -path.h : path.h, acceleration);
      const Verdict verdict(Real(norm(error.x)) / tolerance, Real(norm(error.v)) / tolerance);
      if (verdict.good) path = next;
      path.h = path.h * verdict.change;
    }
    return true;
  }
}

}  // namespace integrate
