// SPDX-License-Identifier: MIT-0
/// @file
/// BDF2: backward Euler that remembers one step more, of order two.
///
/// @code
/// const auto spring = [](double x, double v, double) { return -9 * x - v; };
/// const auto solve = [](double, double, double, double p, double q, double& change) {
///   change = change / (1 + p * -9 + q * -1);  // da/dx is -9, da/dv is -1
///   return true;
/// };
/// const double h = 1 / 60.0;
/// double x = 1, v = 0;
/// auto previous = integrate::bdf2_start(x, v, 0.0, h, spring);
/// bool solved = true;
/// for (int n = 0; n < 60 && solved; ++n) {
///   solved = integrate::bdf2(x, v, previous, n * h, h, h, spring, solve);
/// }
/// @endcode
///
/// With steps as long as the frames are, and to a tolerance, from the same start:
/// @code
/// #include <cmath>
///
/// x = 1, v = 0;
/// double t = 0, h_previous = h;
/// previous = integrate::bdf2_start(x, v, t, h_previous, spring);
/// const auto size = [](double change) { return std::abs(change); };
/// int iterations = 1;
/// for (int n = 0; n < 67 && iterations > 0; ++n) {
///   const double frame = n % 2 == 0 ? 0.01 : 0.02;
///   iterations = integrate::bdf2_newton(x, v, previous, t, frame, h_previous, spring, solve, size,
///                                       1e-9);
///   t = t + frame;
///   h_previous = frame;
/// }
/// @endcode
#pragma once
#include <type_traits>

namespace integrate {

// Checks that BDF2 can use these types; what one lacks is a compile error that says so.
template <class Vec, class Time, class Real, class Acceleration>
constexpr bool bdf2_accepts() {
  constexpr bool calls = std::is_invocable_r_v<Vec, Acceleration&, const Vec&, const Vec&, Time>;
  constexpr auto scale = [](auto s, const auto& y) -> decltype(s * y) { return s * y; };
  constexpr bool scales = std::is_invocable_r_v<Vec, decltype(scale), Real, Vec>;
  static_assert(calls, "acceleration must be callable as Vec(x, v, t)");
  static_assert(!calls || scales,
                "h * x must be a Vec: 1/60.0f for floats; copy Maps; raylib lacks float * Vector3");
  static_assert(!std::is_integral_v<Real>, "h must be no integer");
  return calls && scales;
}

/// The state one step ago, which bdf2 remembers.
/// @see bdf2_start
template <class Vec>
struct Bdf2Previous {
  Vec x;  ///< position
  Vec v;  ///< velocity
};

/// The state one step before the start, for bdf2 to begin with; and again after a blow, a bounce or
/// a jump to another place.
///
/// It is where a step of backward Euler would come from, right to h^2, as order 2 needs. Nothing is
/// solved, and the first step of bdf2 then gives no energy to any spring. With `previous = {x, v}`
/// the order would be 1.
///
/// @param x  position
/// @param v  velocity
/// @param t  time of `x` and `v` [s]
/// @param h_previous  how long that step would have been [s]; not zero. If it is as long as the
/// first step of bdf2, that one takes a third of (h*omega)^2 from the energy of a slow spring,
/// where backward_euler takes all of it. The shorter, the nearer is the first step to the trapezoid
/// rule
/// @param acceleration  callable `(x, v, t) -> Vec` [units of x per s^2]
template <class Vec, class Time, class Real, class Acceleration>
constexpr Bdf2Previous<Vec> bdf2_start(const Vec& x, const Vec& v, Time t, Real h_previous,
                                       Acceleration&& acceleration) {
  if constexpr (bdf2_accepts<Vec, Time, Real, Acceleration>()) {
    // [start-move]
    const Vec a = acceleration(x, v, t);
    return {x + -h_previous * v, v + -h_previous * a};
    // [start-move]
  }
}

/// One step of BDF2, the backward differentiation formula of order two, with a single solve.
///
/// Order 2, one evaluation of the acceleration and one solve, stable on drag for every h, on an
/// undamped spring for every h, also where steps alternate, one up to ten times as long as the
/// other. A parabola through the new state and the last two has there the slope that the force asks
/// for. On a linear force one solve finds that state. On any other it puts a tangent in the force's
/// place, and after a hard blow rope and cloth may gain energy: take bdf2_newton there, if with a
/// tolerance of 10 cm/s and a norm that is content after eight.
///
/// @param x  position, advanced in place
/// @param v  velocity, advanced in place
/// @param previous  position and velocity one step ago, advanced in place; see bdf2_start
/// @param t  time at the start of the step [s]
/// @param h  step size from `x` on [s]; not negative, and not zero: leave a frame of no time out
/// @param h_previous  step size that led from `previous` to `x` [s]
/// @param acceleration  callable `(x, v, t) -> Vec` [units of x per s^2]
/// @param solve  callable `(x, v, t, p, q, change) -> bool`: solves (1 + p da/dx + q da/dv) y =
/// change and puts y into `change`; false if it could not. For a single unknown that is
/// `change = change / (1 + p * dadx + q * dadv)`; for more there are DenseSystem, BandSystem and
/// SparseSystem
/// @returns  false if the system could not be solved; x, v and previous are then as they were
/// @see Hairer and Wanner, Solving Ordinary Differential Equations II (1996), sections V.1 and V.2;
/// of uneven steps, Hairer, Norsett and Wanner, part I (1993), section III.5
template <class Vec, class Time, class Real, class Acceleration, class Solve>
[[nodiscard]] constexpr bool bdf2(Vec& x, Vec& v, Bdf2Previous<Vec>& previous, Time t, Real h,
                                  Real h_previous, Acceleration&& acceleration, Solve&& solve) {
  constexpr bool solves =
      std::is_invocable_r_v<bool, Solve&, const Vec&, const Vec&, Time, Real, Real, Vec&>;
  static_assert(solves, "solve must be callable as bool(x, v, t, p, q, change), change a Vec&");
  if constexpr (bdf2_accepts<Vec, Time, Real, Acceleration>() && solves) {
    using Clock = std::common_type_t<Time, Real>;  // for -Wdouble-promotion
    const Clock t_end = Clock(t) + Clock(h);
    // [move]
    const Real ratio = h / h_previous;
    const Real ahead = ratio * ratio / (Real(1) + Real(2) * ratio);         // 1/3 of even steps
    const Real part = h * (Real(1) + ratio) / (Real(1) + Real(2) * ratio);  // 2/3 of h
    const Vec x_from = x + ahead * Vec(x + Real(-1) * previous.x);
    const Vec v_from = v + ahead * Vec(v + Real(-1) * previous.v);
    const Vec x_end = x_from + part * v_from;
    Vec change = part * acceleration(x_end, v_from, t_end);
    if (!solve(x_end, v_from, t_end, -part * part, -part, change)) return false;
    previous = {x, v};
    v = v_from + change;
    x = x_from + part * v;
    return true;
    // [move]
  }
}

/// One step of BDF2, solved by Newton's method to a tolerance.
///
/// Order 2, one evaluation of the acceleration and one solve for each iteration, stable on drag for
/// every h, on an undamped spring for every h.
///
/// @param x  position, advanced in place
/// @param v  velocity, advanced in place
/// @param previous  position and velocity one step ago, advanced in place; see bdf2_start
/// @param t  time at the start of the step [s]
/// @param h  step size from `x` on [s]; not negative, and not zero: leave a frame of no time out
/// @param h_previous  step size that led from `previous` to `x` [s]
/// @param acceleration  callable `(x, v, t) -> Vec` [units of x per s^2]
/// @param solve  as for bdf2
/// @param norm  callable `(Vec) -> Real`, the size of a change of velocity
/// @param tolerance  the iteration ends when the velocity changes by no more [units of x per s]
/// @returns  how many iterations it took; 0 if it found no end within 50 or a system could not be
/// solved, and x, v and previous are then as they were
/// @see Hairer and Wanner, Solving Ordinary Differential Equations II (1996), section IV.8
template <class Vec, class Time, class Real, class Acceleration, class Solve, class Norm>
[[nodiscard]] constexpr int bdf2_newton(Vec& x, Vec& v, Bdf2Previous<Vec>& previous, Time t, Real h,
                                        Real h_previous, Acceleration&& acceleration, Solve&& solve,
                                        Norm&& norm, Real tolerance) {
  constexpr bool solves =
      std::is_invocable_r_v<bool, Solve&, const Vec&, const Vec&, Time, Real, Real, Vec&>;
  static_assert(solves, "solve must be callable as bool(x, v, t, p, q, change), change a Vec&");
  constexpr bool measures = std::is_invocable_r_v<Real, Norm&, const Vec&>;
  static_assert(measures, "norm must be callable as Real(Vec)");
  if constexpr (bdf2_accepts<Vec, Time, Real, Acceleration>() && solves && measures) {
    using Clock = std::common_type_t<Time, Real>;  // for -Wdouble-promotion
    const Clock t_end = Clock(t) + Clock(h);
    // [newton-move]
    const Real ratio = h / h_previous;
    const Real ahead = ratio * ratio / (Real(1) + Real(2) * ratio);
    const Real part = h * (Real(1) + ratio) / (Real(1) + Real(2) * ratio);
    const Vec x_from = x + ahead * Vec(x + Real(-1) * previous.x);
    const Vec v_from = v + ahead * Vec(v + Real(-1) * previous.v);
    Vec v_end = v_from;
    for (int iteration = 1; iteration <= 50; ++iteration) {
      const Vec x_end = x_from + part * v_end;
      Vec change = v_from + Real(-1) * v_end + part * acceleration(x_end, v_end, t_end);
      if (!solve(x_end, v_end, t_end, -part * part, -part, change)) return 0;
      v_end = v_end + change;
      if (norm(change) <= tolerance) {
        previous = {x, v};
        v = v_end;
        x = x_from + part * v;
        return iteration;
      }
    }
    return 0;
    // [newton-move]
  }
}

}  // namespace integrate
