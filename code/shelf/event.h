// SPDX-License-Identifier: MIT-0
/// @file
/// When something happens within a step: an event, for a force to switch there and nowhere else.
///
/// @code
/// // A ball falls onto a bed of springs, 2 m up, in steps of 1/20 s.
/// struct Ball {
///   double x = 3, v = 0;
/// } ball;
/// double springs = 0;
/// const auto fall = [&](Ball& one, double h) {  // by the midpoint of the step
///   const double middle = one.x + h / 2 * one.v;
///   const double v = one.v + h / 2 * (springs * (2 - one.x) - 9.81);
///   one.x = one.x + h * v, one.v = one.v + h * (springs * (2 - middle) - 9.81);
/// };
/// const auto above = [](const Ball& one) { return one.x - 2; };
/// double met = 0;
/// for (int n = 0; n < 12; ++n) {
///   double left = 1 / 20.0;
///   const auto crossing = shelf::first_crossing(ball, left, fall, above);
///   if (springs == 0 && crossing.found) {
///     fall(ball, crossing.time);  // so far without springs, and from here on with them
///     met = n / 20.0 + crossing.time;
///     left = left - crossing.time;
///     springs = 400;
///   }
///   fall(ball, left);
/// }
/// // Now met is 0.451524.
/// // Now ball.x is 1.986.
/// @endcode
///
/// A step across a place where a force switches loses its order: RK4 is of order 1 there, like
/// Euler's method, if the force jumps, and of order 2 if only its slope does. Go to that place,
/// switch, and go on. A time is an event as well, as where a road has a kerb: let the state have
/// the time in it. It costs one step more in each, and in the one in which it happens some ten,
/// some tens where the number jumps, and in odd cases a hundred or two.
///
/// Afterwards the number is zero or hardly below, where no second event is found: a ball that
/// bounces has to be put hardly above the ground, by some roundings, before the next call. If each
/// bounce takes some of its speed, no step is short enough for the last of them: take bounce.h.
/// What is there only for a short time, like a thin wall, is seen if `parts` are so many that none
/// is longer.
///
/// Promises:
/// - a ball that falls meets the ground when impact_plane says so, to 1e-13 of the step
/// - for that it asks for no more than 18 steps
/// - over a kerb at 1.0037 s RK4 keeps its order of 4, to 0.1
/// - there, at 64 Hz, it is more than fifty times nearer than across the kerb
/// - in float, too, the event is never above zero at the time that it says
#pragma once
#include <limits>
#include <type_traits>

namespace shelf {

/// Whether something was met, and when.
template <class Real>
struct Crossing {
  bool found;
  Real time;  ///< since the start of the step, when it is met or hardly later [s]
};

/// The first time within a step at which a number that is above zero comes to zero or below.
///
/// The step is tried with shorter lengths, each from the same start, by a method of your own. What
/// comes to zero and goes again within one of its parts can go by unseen. Calls nothing of the C
/// library.
///
/// @param start  at the start of the step: whatever `step` takes
/// @param h  step size [s]
/// @param step  callable `(State&, Real)`: advances a state by so much, at most h
/// @param event  callable `(const State&) -> Real`: above zero before it happens
/// @param parts  in which the step is looked through, from the first on; above 0
/// @returns  a time at which `event` was asked for and was not above zero; the time before which it
/// was is less than 4 roundings of h away. None if it or h is not above zero at the start
/// @see M. Dowell and P. Jarratt, A modified regula falsi method, BIT 11 (1971)
template <class State, class Real, class Step, class Event>
constexpr Crossing<Real> first_crossing(const State& start, Real h, Step&& step, Event&& event,
                                        int parts = 1) {
  constexpr bool steps = std::is_invocable_v<Step&, State&, Real>;
  constexpr bool tells = std::is_invocable_r_v<Real, Event&, const State&>;
  static_assert(steps, "step must be callable as step(state, h)");
  static_assert(tells, "event must be callable as Real(state)");
  static_assert(!std::is_integral_v<Real>, "h must be no integer");
  if constexpr (steps && tells) {
    // [crossing]
    const auto after = [&](Real time) {
      State state = start;
      step(state, time);
      return Real(event(state));
    };
    Real before = 0, above = event(start), met = 0, below = 1;
    if (!(above > Real(0)) || !(h > Real(0))) return {false, Real(0)};
    for (int part = 1; part <= parts && below > Real(0); ++part) {
      met = part < parts ? h * (Real(part) / Real(parts)) : h;
      below = after(met);
      if (below > Real(0)) before = met, above = below;
    }
    if (!(below <= Real(0))) return {false, Real(0)};
    const Real close = Real(4) * std::numeric_limits<Real>::epsilon() * h;
    for (int tries = 1, side = 0; met - before > close; ++tries) {
      Real time = before + (met - before) * (above / (above - below));
      if (tries % 3 == 0 || !(time >= before && time <= met))
        time = before + (met - before) / Real(2);
      // Where one end is as near as it can be, a little further on is the other one.
      if (time - before < close / Real(2)) time = before + close / Real(2);
      if (met - time < close / Real(2)) time = met - close / Real(2);
      if (!(time > before && time < met)) break;  // there is no number between the two
      const Real there = after(time);
      const int now = there > Real(0) ? 1 : -1;
      if (now > 0) before = time, above = there;
      if (now < 0) met = time, below = there;
      // An end that stays for long would hold the chord back.
      if (now == side && now > 0) below = below / Real(2);
      if (now == side && now < 0) above = above / Real(2);
      side = now;
    }
    return {true, met};
    // [crossing]
  } else {
    return {false, Real(0)};
  }
}

}  // namespace shelf
