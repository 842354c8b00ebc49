// SPDX-License-Identifier: MIT-0
/// @file
/// Throws by the very step that the game makes: where one lands, and which one hits what moves.
///
/// @code
/// #include <cmath>
/// #include <complex>
/// // Shells of 60 m/s, which the square of their speed slows down, in ticks of 1/60 s.
/// using Vec = std::complex<double>;
/// const auto step = [](Vec& x, Vec& v) {  // one tick of your game, all of it
///   const Vec before = v;
///   v = (v + 1 / 60.0 * Vec(0, -9.81)) / (1 + 0.005 / 60 * std::abs(v));
///   x = x + 0.5 / 60 * (before + v);
/// };
/// const auto dot = [](Vec a, Vec b) { return std::real(a * std::conj(b)); };
/// const auto height = [](Vec x) { return std::imag(x); };
/// const auto fall = shelf::landing(Vec(0, 2), Vec(50, 30), 1 / 60.0, 20.0, step, height);
/// // Now std::real(fall.place) is 160.46.
/// // Now fall.time is 5.099.
///
/// const auto tank = [](double t) { return Vec(90 - 8 * t, 1); };  // comes nearer
/// const shelf::Gun<double> gun{60, 1 / 60.0, 20, 0.001};
/// const auto shot = shelf::aim(Vec(0, 2), tank, step, dot, gun);
/// // Now shot.time is 1.587.
/// const auto lob = shelf::aim(Vec(0, 2), tank, step, dot, gun, shot.time + gun.h);
/// // Now lob.time is 9.256.
///
/// Vec x(0, 2), v = shot.velocity, before;  // and the shell does fly there
/// for (int n = 0; n < 96; ++n) before = x, step(x, v);
/// // Now std::real(before) is 77.2.
/// // Now std::real(x) is 77.8.
/// @endcode
///
/// To draw the arc, call `step` as often and join the places: it is the shell's path to the bit, as
/// long as the game makes no other step. Between two ticks the thing is on the straight line that
/// joins them, as it is for a ray cast from one to the next. Of two throws, `aim` finds the flat
/// one; asked again with a time after that one, the high one.
///
/// A throw that takes a given time, where drag goes with the speed itself: the place after so many
/// ticks is then linear in the velocity at the start, and two flights tell all.
/// @code
/// #include <complex>
/// using Vec = std::complex<double>;
/// const auto flight = [](Vec v) {  // where it is after 90 ticks of 1/60 s
///   Vec x(0, 2);
///   for (int n = 0; n < 90; ++n) {
///     v = (v + 1 / 60.0 * Vec(0, -9.81)) / (1 + 0.3 / 60);
///     x = x + 1 / 60.0 * v;
///   }
///   return x;
/// };
/// const Vec still = flight(0), reach = flight(1) - still, target(20, 1);
/// const Vec hit = flight((target - still) / reach);
/// // Now std::real(hit) is 20.
/// // Now std::imag(hit) is 1.
/// @endcode
///
/// With constant velocities and without drag there is a formula, a quadratic for the time. Here
/// whatever the step has counts: drag, wind, a homing target's own path. A shot costs some thousand
/// steps, a lob with drag some twenty thousand, and to find that there is none some hundred
/// thousand: aim once, not in each frame.
///
/// Promises:
/// - without drag the throw and its time are those of the formula, to 1e-3 of the speed, for the
///   flat one and the high one
/// - with drag by the square, c v up to 3 1/s, wind and targets that move, its shells come as near
///   as was asked for, a millimetre, and leave with the speed to 1e-14 of it
/// - of 90 places it finds a throw for each that a search through two thousand directions comes
///   within 10 cm of, and for none that it stays a metre away from
/// - for these flat shots it asks for no more than 10000 steps, for the high ones for 60000, and
///   where there was none for 210000
/// - a landing is on the line between two ticks of the same flight, to the bit
#pragma once
#include <cmath>
#include <cstdint>
#include <limits>
#include <type_traits>

namespace shelf {

/// Where and when a thing comes down.
template <class Vec, class Real>
struct Landing {
  bool found;  ///< whether it came down within the time; else where it is then
  Vec place;   ///< between two ticks
  Real time;   ///< since the start [s]
};

/// What throws, how fast, and in which ticks.
template <class Real>
struct Gun {
  Real speed;    ///< with which things are thrown; above zero [m/s]
  Real h;        ///< length of a tick; above zero [s]
  Real longest;  ///< flight that is thought of; below 10^9 ticks [s]
  Real within;   ///< how far off it may be; not below the roundings of such a place [m]
};

/// A throw that hits.
template <class Vec, class Real>
struct Aim {
  bool found;    ///< whether there is one
  Vec velocity;  ///< with which to throw [m/s]
  Real time;     ///< until it hits [s]
};

/// A flight in ticks, and the velocity that it needs to be somewhere after a time.
template <class Vec, class Real, class Target, class Step, class Dot>
struct Aiming {
  const Vec& from;       ///< where it begins
  const Gun<Real>& gun;  ///< what throws
  Target& target;        ///< where what is to be hit is, after a time
  Step& step;            ///< one tick
  Dot& dot;              ///< the dot product
  Vec velocity;          ///< the last one that met the target
  Real time;             ///< after which it did
  Real gain;             ///< change of velocity times time, over the change of place

  /// Where a flight is after a time, on the line between two ticks.
  Vec place(Vec v, Real after) const {
    Vec x = from;
    const Real ticks = after / gun.h;
    const auto whole = static_cast<std::int64_t>(ticks);
    for (std::int64_t n = 0; n < whole; ++n) step(x, v);
    const Vec before = x;
    step(x, v);
    return before + (ticks - Real(whole)) * (x + Real(-1) * before);
  }

  /// Whether a flight is near enough to the target after a time.
  bool meets(const Vec& v, Real after) const {
    const Vec miss = target(after) + Real(-1) * place(v, after);
    return dot(miss, miss) <= gun.within * gun.within;
  }

  /// By how much the velocity that meets the target after a time is too fast; the largest number if
  /// none is found. Corrects it by what it misses by, as many times as needed: by the step lengths
  /// of Barzilai and Borwein.
  Real excess(Real after) {
    const Vec goal = target(after);
    Vec v = (time / after) * velocity, there = place(v, after);
    Real share = gain / after;
    for (int tries = 0; tries < 30; ++tries) {
      const Vec miss = goal + Real(-1) * there;
      if (dot(miss, miss) <= gun.within * gun.within / Real(16)) {
        velocity = v, time = after, gain = share * after;
        return std::sqrt(dot(v, v)) - gun.speed;
      }
      const Vec change = share * miss;
      v = v + change;
      if (!(dot(v, v) < Real(100) * gun.speed * gun.speed)) break;
      const Vec next = place(v, after), moved = next + Real(-1) * there;
      const Real along = dot(change, moved), all = dot(moved, moved);
      share = along > Real(0) && all > Real(0) ? along / all : share / Real(2);
      there = next;
    }
    return (std::numeric_limits<Real>::max)();
  }
};

/// Two times between which the speed that is needed becomes that of the gun.
template <class Real>
struct AimBracket {
  bool found = false;     ///< whether there are such times
  Real early = 0;         ///< the first of them [s]
  Real early_excess = 0;  ///< by how much too fast it must be then [m/s]
  Real late = 0;          ///< the second [s]
  Real late_excess = 0;   ///< and then: of the other sign [m/s]

  /// The least excess between two times, by the golden section, until one is not above zero.
  template <class Excess>
  static AimBracket dip(Real left, Real left_excess, Real middle, Real least, Real right,
                        Excess& excess) {
    const Real golden = Real(0.3819660113);
    for (int n = 0; n < 24; ++n) {
      const bool after = right - middle > middle - left;
      const Real time =
          after ? middle + golden * (right - middle) : middle - golden * (middle - left);
      const Real there = excess(time);
      if (there <= Real(0)) {
        return {true, after ? middle : left, after ? least : left_excess, time, there};
      }
      const bool lower = there < least;
      if (lower == after) {
        left = lower ? middle : time, left_excess = lower ? least : there;
      } else {
        right = lower ? middle : time;
      }
      if (lower) middle = time, least = there;
    }
    return {};
  }

  /// The first such times from one on, in strides of a quarter.
  template <class Excess>
  static AimBracket first(Real from, Real longest, Excess& excess) {
    Real before = from, late = from;
    Real before_excess = excess(from), late_excess = before_excess;
    const bool fast = before_excess > Real(0);
    while (late < longest) {
      const Real next = late * Real(1.25) < longest ? late * Real(1.25) : longest;
      if (!(next > late)) break;  // too short for a number to lie between
      const Real there = excess(next);
      if ((there > Real(0)) != fast) return {true, late, late_excess, next, there};
      if (fast && there > late_excess) {
        const AimBracket dips = dip(before, before_excess, late, late_excess, next, excess);
        if (dips.found) return dips;
      }
      before = late, before_excess = late_excess;
      late = next, late_excess = there;
    }
    return {};
  }
};

/// Where a throw comes down: on the line between the tick before and the tick after.
///
/// Looks at ticks alone: what is below the ground in between goes by unseen.
///
/// @param x  where it begins
/// @param v  its velocity then
/// @param h  length of a tick; above zero [s]
/// @param longest  flight that is looked at; below 10^9 ticks [s]
/// @param step  callable `(Vec&, Vec&)`: advances place and velocity by a tick, as your game does
/// @param height  callable `(Vec) -> Real`: above the ground, of any kind [m]
template <class Vec, class Real, class Step, class Height>
Landing<Vec, Real> landing(Vec x, Vec v, Real h, Real longest, Step&& step, Height&& height) {
  constexpr auto scale = [](auto s, const auto& y) -> decltype(s * y) { return s * y; };
  constexpr bool scales = std::is_invocable_r_v<Vec, decltype(scale), Real, Vec>;
  constexpr bool steps = std::is_invocable_v<Step&, Vec&, Vec&>;
  constexpr bool measures = std::is_invocable_r_v<Real, Height&, const Vec&>;
  static_assert(scales,
                "h * x must be a Vec: 1/60.0f for floats; copy Maps; raylib lacks float * Vector3");
  static_assert(steps, "step must be callable as step(x, v)");
  static_assert(measures, "height must be callable as Real(Vec)");
  static_assert(!std::is_integral_v<Real>, "h must be no integer");
  if constexpr (scales && steps && measures) {
    // [landing]
    Real above = height(x);
    for (std::int64_t n = 0; Real(n) * h < longest && h > Real(0); ++n) {
      const Vec before = x;
      step(x, v);
      const Real below = height(x);
      if (above > Real(0) && below <= Real(0)) {
        const Real share = above / (above - below);
        return {true, before + share * (x + Real(-1) * before), (Real(n) + share) * h};
      }
      above = below;
    }
    return {false, x, longest};
    // [landing]
  } else {
    return {false, x, longest};
  }
}

/// The throw that hits something, which may move.
///
/// Takes the first time at which the speed of the gun is enough, or, if it is more than enough at
/// `after`, the first at which it is no longer. Roots are sought in strides of a quarter of the
/// time: of a target that zigzags faster than that, some meeting may be missed, as of one that
/// comes in with more than three times the speed of the gun.
///
/// @param from  where it begins
/// @param target  callable `(Real) -> Vec`: where that is, so long after the throw
/// @param step  callable `(Vec&, Vec&)`: advances place and velocity by a tick, as your game does
/// @param dot  callable `(Vec, Vec) -> Real`, the dot product
/// @param gun  how fast, in which ticks, and how near
/// @param after  time that it takes at least [s]; for the high throw, that of the flat one and a
/// tick
/// @see J. Barzilai and J. M. Borwein, Two-point step size gradient methods, IMA Journal of
/// Numerical Analysis 8 (1988)
template <class Vec, class Real, class Target, class Step, class Dot>
Aim<Vec, Real> aim(const Vec& from, Target&& target, Step&& step, Dot&& dot, const Gun<Real>& gun,
                   std::decay_t<Real> after = Real(0)) {
  constexpr auto scale = [](auto s, const auto& y) -> decltype(s * y) { return s * y; };
  constexpr bool scales = std::is_invocable_r_v<Vec, decltype(scale), Real, Vec>;
  constexpr bool aims = std::is_invocable_r_v<Vec, Target&, Real>;
  constexpr bool steps = std::is_invocable_v<Step&, Vec&, Vec&>;
  constexpr bool dots = std::is_invocable_r_v<Real, Dot&, const Vec&, const Vec&>;
  static_assert(scales,
                "h * x must be a Vec: 1/60.0f for floats; copy Maps; raylib lacks float * Vector3");
  static_assert(aims, "target must be callable as Vec(time)");
  static_assert(steps, "step must be callable as step(x, v)");
  static_assert(dots, "dot must be callable as Real(Vec, Vec)");
  static_assert(!std::is_integral_v<Real>, "the numbers of a gun must be no integers");
  if constexpr (scales && aims && steps && dots) {
    // [aim]
    // A quarter of the time to where it is now: what is nearer than a tick's flight is hit, too.
    const Vec way = target(Real(0)) + Real(-1) * from;
    const Real soon = std::sqrt(dot(way, way)) / (Real(4) * gun.speed);
    const Real least = soon > Real(0) && soon < gun.h ? soon : gun.h;
    const Real first = !(after > Real(0)) ? least : after > gun.h ? after : gun.h;
    if (!(gun.speed > Real(0)) || !(gun.h > Real(0)) || !(first < gun.longest) ||
        !(gun.longest < Real(1e9) * gun.h))
      return {false, Real(0) * from, Real(0)};
    const Vec straight = (Real(1) / first) * (target(first) + Real(-1) * from);
    Aiming<Vec, Real, Target, Step, Dot> aiming{from, gun,      target, step,
                                                dot,  straight, first,  Real(1)};
    const auto excess = [&aiming](Real time) { return aiming.excess(time); };
    auto [found, early, early_excess, late, late_excess] =
        AimBracket<Real>::first(first, gun.longest, excess);
    for (int n = 0; n < 100 && found; ++n) {
      Real time = early + (late - early) * (early_excess / (early_excess - late_excess));
      if (n % 3 == 2 || !(time > early && time < late)) time = early + (late - early) / Real(2);
      if (!(time > early && time < late)) break;
      const Real there = excess(time);
      if (there < (std::numeric_limits<Real>::max)()) {
        const Vec v = (gun.speed / (gun.speed + there)) * aiming.velocity;
        if (aiming.meets(v, time)) return {true, v, time};
      }
      const bool is_early = (there > Real(0)) == (early_excess > Real(0));
      (is_early ? early : late) = time;
      (is_early ? early_excess : late_excess) = there;
    }
    return {false, Real(0) * from, Real(0)};
    // [aim]
  } else {
    return {false, from, Real(0)};
  }
}

}  // namespace shelf
