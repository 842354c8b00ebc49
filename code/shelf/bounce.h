// SPDX-License-Identifier: MIT-0
/// @file
/// A ball that bounces off a plane at the moment when it meets it, slides and comes to rest.
///
/// @code
/// // Dropped from 2 m, it keeps 0.8 of its speed at each bounce, and stays down below 0.5 m/s.
/// double x = 2, v = 0;
/// const auto dot = [](double a, double b) { return a * b; };
/// const shelf::Plane<double, double> floor{1, 0, 0.8, 0, 0.5};  // up is 1, at a height of 0
/// int bounces = 0;
/// for (int n = 0; n < 60 * 6; ++n) {
///   bounces += shelf::bounce_step(x, v, -9.81, 1 / 60.0, floor, dot);
/// }
/// // Now bounces is 12.
/// // Now x is 0.
/// // Now v is 0.
/// @endcode
///
/// When a stone lands from 5 cm above the ground, and when a bullet of 2 cm meets a ball of 50 cm:
/// @code
/// const auto lands = shelf::impact_plane(0.05, -6.0, -9.81, 1 / 60.0);
/// const auto dot = [](double a, double b) { return a * b; };
/// const double from_ball = -10, speed = 900;
/// const auto hit = shelf::impact_sphere(from_ball, speed, 0.52, 1 / 60.0, dot);
/// // Now lands.time is 0.00828.
/// // Now hit.time is 0.01053333.
/// @endcode
///
/// In a step of your own, a puck that slides on ice: a point, which does not turn. A complex number
/// is a vector, right and up:
/// @code
/// #include <complex>
/// using Flat = std::complex<double>;
/// const auto dot = [](Flat p, Flat q) { return p.real() * q.real() + p.imag() * q.imag(); };
/// const Flat up(0, 1);
/// Flat x = 0, v = 2;
/// for (int n = 0; n < 180; ++n) {
///   v = v + 1 / 60.0 * Flat(0, -9.81);
///   const double push = shelf::bounce(v, up, 0.5, 1.0, dot);
///   shelf::friction(v, up, 0.1 * push, dot);
///   x = x + 1 / 60.0 * v;
/// }
/// // Now x.real() is 2.02.
/// // Now v.real() is 0.
/// @endcode
///
/// On a platform that goes up and down by 2 m: what it carries stays on it.
/// @code
/// #include <cmath>
/// const auto dot = [](double a, double b) { return a * b; };
/// const auto platform = [](double t) {
///   const double x = 2 * std::sin(2 * t), v = 4 * std::cos(2 * t);
///   return shelf::MovingPlane<double, double>{{1, 0, 0.5, 0.4, 0.5}, x, v};
/// };
/// double x = 0, v = 4;
/// for (int n = 0; n < 120; ++n) {
///   const double t = n / 60.0;
///   shelf::bounce_step(x, v, -9.81, 1 / 60.0, platform(t), platform(t + 1 / 60.0), dot);
/// }
/// const double above = x - platform(2.0).x;
/// // Now above is 0.
/// @endcode
///
/// Two balls on a table, of 5.7 cm each. Seen from one of them, the other is a point, and the one
/// has both radii:
/// @code
/// #include <complex>
/// using Flat = std::complex<double>;
/// const auto dot = [](Flat p, Flat q) { return p.real() * q.real() + p.imag() * q.imag(); };
/// Flat x1(-0.06, 0.03), x2 = 0, v1 = 3, v2 = 0;
/// const auto hit = shelf::impact_sphere(x1 - x2, v1 - v2, 0.057, 1 / 60.0, dot);
/// const Flat line = (x1 + hit.time * v1 - (x2 + hit.time * v2)) / 0.057;
/// Flat between = v1 - v2;
/// const double push = shelf::bounce(between, line, 0.95, 0.0, dot);
/// v1 = v1 + push / 2 * line;  // of other masses: m2 / (m1 + m2)
/// v2 = v2 - push / 2 * line;  // and m1 / (m1 + m2)
/// // Now hit.time is 0.003845.
/// // Now std::abs(v1) is 1.5802.
/// // Now std::abs(v2) is 2.4871.
/// @endcode
///
/// The pushes here are speeds, those of a point. What a push at the corner of a body does, which
/// turns it, see in orientation.h, and how it comes to rest on several corners in contact.h.
///
/// Promises:
/// - a plane is met where the height is 0, to 10^-14 m in falls of some metres, and never later
///   than at the first such moment
/// - a sphere is met, on a straight way or a bent one, where its surface is, to 10^-13 m, and
///   never later than at the first such moment
/// - dropped from 2 m and bouncing without loss, a ball keeps its energy for a hundred bounces to
///   10^-13, at 15, 60 and 144 steps a second; as Box2D 3 bounces, with 4 substeps at 60, 22 % is
///   left, and as Jolt does, it is off by up to 2.6 %
/// - each bounce comes when it is due, to 10^-12 m, whatever the step
/// - slower than the threshold it comes to rest, and then neither place nor velocity changes by a
///   bit on a level floor
/// - a puck slides v^2 / (2 mu g) and stops, to mu g h^2 / 8
/// - on a slope friction holds it as long as the tangent of the slope is below mu
/// - a platform that swings by 2 m with 2 rad/s carries a ball, which is on it after each step to
///   10^-15 m, at 15 to 240 Hz
/// - with 3 rad/s it leaves the platform where that falls faster than a stone, and is at 60 Hz
///   within 2 mm of its flight from there
/// - from a floor that rises or sinks it comes back with its share of the speed at which they met,
///   to 10^-13 m/s
/// - on a floor that tilts it begins to slide within three steps of when the tangent of the angle
///   is mu
#pragma once
#include <cmath>
#include <type_traits>

namespace shelf {

/// Whether something is met within a step, and when.
template <class Real>
struct Impact {
  bool hit = false;     ///< whether it is met
  Real time = Real(0);  ///< how long after the start of the step [s]
};

/// When a point comes down on a plane.
///
/// A point that is on the plane or below, and goes down or is drawn down from rest, meets it at
/// once.
///
/// @param height  above the plane, less the radius of a ball [m]
/// @param speed  away from the plane [m/s]
/// @param acceleration  away from the plane, throughout the step; 0 for a straight way [m/s^2]
/// @param h  step size [s]; not negative
/// @returns  the first moment within the step at which it goes through from above; none if an
/// argument is not a number
template <class Real>
Impact<Real> impact_plane(Real height, Real speed, Real acceleration, Real h) {
  static_assert(!std::is_integral_v<Real>, "h must be no integer");
  const Real zero = Real(0);
  const Real square = speed * speed - Real(2) * acceleration * height;
  if (!(square == square) || !(h >= zero)) return {};    // one of them is not a number
  if (speed >= zero && acceleration >= zero) return {};  // it never comes down
  // At once, too, from rest so near to it that the square is lost in rounding.
  if ((height <= zero && speed < zero) || (speed == zero && square <= zero)) return {true, zero};
  if (!(square >= zero)) return {};  // it turns before it comes down
  // Of the two forms of the root the one that subtracts nothing.
  const Real root = std::sqrt(square);
  const Real above = speed > zero ? -speed - root : Real(2) * height;
  const Real below = speed > zero ? acceleration : root - speed;
  const Real time = above / below;
  if (!(time >= zero) || !(time <= h)) return {};
  return {true, time};
}

/// When a point on a straight way comes into a sphere.
///
/// A point that is within already, and goes further in, meets it at once. It calls a square root.
///
/// @param x  place of the point, seen from the centre of the sphere [m]
/// @param v  its velocity, seen from the sphere [m/s]
/// @param radius  of the sphere, with that of a ball added [m]; not negative
/// @param h  step size [s]; not negative
/// @param dot  callable `(Vec, Vec) -> Real`, the dot product
/// @returns  the first moment within the step; none if an argument is not a number
/// @see C. Ericson, Real-Time Collision Detection (2005), section 5.3.2
template <class Vec, class Real, class Dot>
Impact<Real> impact_sphere(const Vec& x, const Vec& v, Real radius, Real h, Dot&& dot) {
  constexpr auto scale = [](auto s, const auto& y) -> decltype(s * y) { return s * y; };
  constexpr bool scales = std::is_invocable_r_v<Vec, decltype(scale), Real, Vec>;
  constexpr bool dots = std::is_invocable_r_v<Real, Dot&, const Vec&, const Vec&>;
  static_assert(scales,
                "h * x must be a Vec: 1/60.0f for floats; copy Maps; raylib lacks float * Vector3");
  static_assert(dots, "dot must be callable as Real(Vec, Vec)");
  static_assert(!std::is_integral_v<Real>, "h must be no integer");
  if constexpr (scales && dots) {
    const Real closing = -Real(dot(x, v)), fast = dot(v, v);
    if (!(closing > Real(0)) || !(h >= Real(0))) return {};
    const Real distance = std::sqrt(Real(dot(x, x)));
    const Real outside = (distance - radius) * (distance + radius);
    if (outside <= Real(0)) return {true, Real(0)};
    // By how much it would pass the centre: closing^2 - fast * outside would lose it far away.
    const Vec miss = x + (closing / fast) * v;
    const Real square = fast * (radius * radius - Real(dot(miss, miss)));
    if (!(square >= Real(0))) return {};
    const Real time = outside / (closing + std::sqrt(square));
    if (!(time <= h)) return {};
    return {true, time};
  }
}

/// When a point that is accelerated comes into a sphere.
///
/// It looks for the roots of a polynomial by halving, 60 times for each of ten at most, and calls a
/// square root. Without an acceleration the other impact_sphere says the same sooner.
///
/// @param x  place of the point, seen from the centre of the sphere [m]
/// @param v  its velocity, seen from the sphere [m/s]
/// @param a  its acceleration throughout the step [m/s^2]
/// @param radius  of the sphere, with that of a ball added [m]; not negative
/// @param h  step size [s]; not negative
/// @param dot  callable `(Vec, Vec) -> Real`, the dot product
/// @returns  the first moment within the step; none if an argument is not a number
template <class Vec, class Real, class Dot>
Impact<Real> impact_sphere(const Vec& x, const Vec& v, const Vec& a, Real radius, Real h,
                           Dot&& dot) {
  constexpr auto scale = [](auto s, const auto& y) -> decltype(s * y) { return s * y; };
  constexpr bool scales = std::is_invocable_r_v<Vec, decltype(scale), Real, Vec>;
  constexpr bool dots = std::is_invocable_r_v<Real, Dot&, const Vec&, const Vec&>;
  static_assert(scales,
                "h * x must be a Vec: 1/60.0f for floats; copy Maps; raylib lacks float * Vector3");
  static_assert(dots, "dot must be callable as Real(Vec, Vec)");
  static_assert(!std::is_integral_v<Real>, "h must be no integer");
  if constexpr (scales && dots) {
    // The square of the distance less that of the radius, by powers of the share of the step that
    // is over. Between two roots of its slope it has one root or none, and its slope the same.
    const Vec way = h * v, bend = (h * h / Real(2)) * a;
    const Real distance = std::sqrt(Real(dot(x, x)));
    Real c[5] = {(distance - radius) * (distance + radius), Real(2) * Real(dot(x, way)),
                 Real(dot(way, way)) + Real(2) * Real(dot(x, bend)), Real(2) * Real(dot(way, bend)),
                 dot(bend, bend)};
    const Real all = c[0] + c[1] + c[2] + c[3] + c[4];
    if (!(all == all) || !(h >= Real(0))) return {};  // one of them is not a number
    if (c[0] <= Real(0) && (c[1] < Real(0) || (c[1] == Real(0) && c[2] < Real(0)))) {
      return {true, Real(0)};
    }
    Real turns[6] = {Real(0), Real(1)};
    int last = 1;
    for (int slope = 3; slope >= 0; --slope) {
      const auto value = [&](Real share) {
        Real sum = Real(0);
        for (int power = 4; power >= slope; --power) {
          Real factor = c[power];
          for (int i = 0; i < slope; ++i) factor = factor * Real(power - i);
          sum = sum * share + factor;
        }
        return sum;
      };
      Real found[6] = {Real(0)};
      int count = 0;
      for (int i = 0; i < last; ++i) {
        Real low = turns[i], high = turns[i + 1];
        const bool falls = value(low) > Real(0);
        if (falls == (value(high) > Real(0))) continue;
        for (int halving = 0; halving < 60; ++halving) {
          const Real middle = (low + high) / Real(2);
          (falls == (value(middle) > Real(0)) ? low : high) = middle;
        }
        if (slope == 0 && falls) return {true, h * high};
        found[++count] = high;
      }
      for (int i = 1; i <= count; ++i) turns[i] = found[i];
      last = count + 1;
      turns[last] = Real(1);
    }
    return {};
  }
}

/// Turns the velocity round that goes into a plane.
///
/// @param v  velocity, changed in place [m/s]
/// @param normal  away from the plane, of length 1
/// @param restitution  share of the speed that comes back, 0 to 1
/// @param threshold  speed below which nothing comes back, so that it comes to rest; 1 m/s in Box2D
/// and Jolt [m/s]
/// @param dot  callable `(Vec, Vec) -> Real`, the dot product
/// @returns  the push of the plane: the change of speed, 0 if it goes away anyway [m/s]
template <class Vec, class Real, class Dot>
constexpr Real bounce(Vec& v, const Vec& normal, Real restitution, Real threshold, Dot&& dot) {
  constexpr auto scale = [](auto s, const auto& y) -> decltype(s * y) { return s * y; };
  constexpr bool scales = std::is_invocable_r_v<Vec, decltype(scale), Real, Vec>;
  constexpr bool dots = std::is_invocable_r_v<Real, Dot&, const Vec&, const Vec&>;
  static_assert(
      scales,
      "restitution * v must be a Vec: 1/60.0f for floats; copy Maps; raylib lacks float * Vector3");
  static_assert(dots, "dot must be callable as Real(Vec, Vec)");
  static_assert(!std::is_integral_v<Real>, "restitution must be no integer");
  if constexpr (scales && dots) {
    const Real into = -Real(dot(v, normal));
    if (!(into > Real(0))) return Real(0);
    const Real push = into < threshold ? into : (Real(1) + restitution) * into;
    v = v + push * normal;
    return push;
  }
}

/// Brakes the velocity along a plane, and stops it when it can: dry friction.
///
/// It calls a square root.
///
/// @param v  velocity, changed in place [m/s]
/// @param normal  away from the plane, of length 1
/// @param most  by how much at most: the coefficient of friction times the push of the plane [m/s]
/// @param dot  callable `(Vec, Vec) -> Real`, the dot product
/// @see C. A. Coulomb, Théorie des machines simples (1785)
template <class Vec, class Real, class Dot>
void friction(Vec& v, const Vec& normal, Real most, Dot&& dot) {
  constexpr auto scale = [](auto s, const auto& y) -> decltype(s * y) { return s * y; };
  constexpr bool scales = std::is_invocable_r_v<Vec, decltype(scale), Real, Vec>;
  constexpr bool dots = std::is_invocable_r_v<Real, Dot&, const Vec&, const Vec&>;
  static_assert(
      scales,
      "most * v must be a Vec: 1/60.0f for floats; copy Maps; raylib lacks float * Vector3");
  static_assert(dots, "dot must be callable as Real(Vec, Vec)");
  static_assert(!std::is_integral_v<Real>, "most must be no integer");
  if constexpr (scales && dots) {
    const Vec away = Real(dot(v, normal)) * normal;
    const Vec along = v + Real(-1) * away;
    const Real speed = std::sqrt(Real(dot(along, along)));
    v = speed <= most ? away : Vec(away + ((speed - most) / speed) * along);
  }
}

/// A plane to bounce off, and what it is like. See bounce_step. C++17 finds no types for it: write
/// Plane<Vec, Real>{...}.
template <class Vec, class Real>
struct Plane {
  Vec normal;        ///< away from it, of length 1
  Real level;        ///< dot product of the normal and any of its points, plus a ball's radius [m]
  Real restitution;  ///< share of the speed that comes back, 0 to 1
  Real friction;     ///< coefficient of dry friction; not negative
  Real threshold;    ///< speed below which nothing comes back [m/s]
};

/// One step of a point or a ball above a plane: it falls, bounces when it is there, slides, rests.
///
/// Between bounces it is exact under a constant acceleration, so no step size changes the bounces.
/// It may bounce often within a step, 64 times at most; then it stays down. One that is below the
/// plane at the start is put onto it. It calls square roots.
///
/// @param x  place, advanced in place [m]
/// @param v  velocity, advanced in place [m/s]
/// @param a  acceleration throughout the step, of gravity as a rule [m/s^2]
/// @param h  step size [s]; not negative
/// @param plane  what it bounces off
/// @param dot  callable `(Vec, Vec) -> Real`, the dot product
/// @returns  how often it came up again
template <class Vec, class Real, class Dot>
int bounce_step(Vec& x, Vec& v, const Vec& a, Real h, const Plane<Vec, Real>& plane, Dot&& dot) {
  constexpr auto scale = [](auto s, const auto& y) -> decltype(s * y) { return s * y; };
  constexpr bool scales = std::is_invocable_r_v<Vec, decltype(scale), Real, Vec>;
  constexpr bool dots = std::is_invocable_r_v<Real, Dot&, const Vec&, const Vec&>;
  static_assert(scales,
                "h * x must be a Vec: 1/60.0f for floats; copy Maps; raylib lacks float * Vector3");
  static_assert(dots, "dot must be callable as Real(Vec, Vec)");
  static_assert(!std::is_integral_v<Real>, "h must be no integer");
  if constexpr (scales && dots) {
    const Real pull = dot(a, plane.normal);
    Real left = h;
    for (int bounces = 0;;) {
      Real height = Real(dot(x, plane.normal)) - plane.level;
      if (height < Real(0)) {
        x = x + (-height) * plane.normal;
        height = Real(0);
      }
      const Impact<Real> fall = impact_plane(height, Real(dot(v, plane.normal)), pull, left);
      const Real time = fall.hit ? fall.time : left;
      x = x + (time * v + (time * time / Real(2)) * a);
      v = v + time * a;
      left = left - time;
      if (!fall.hit) return bounces;

      const bool rests = bounces == 64 || !(-Real(dot(v, plane.normal)) > plane.threshold);
      const Real push =
          bounce(v, plane.normal, rests ? Real(0) : plane.restitution, plane.threshold, dot);
      friction(v, plane.normal, plane.friction * push, dot);
      if (!rests) {
        ++bounces;
      } else if (pull < Real(0)) {
        const Vec before = v;
        v = v + left * Vec(a + (-pull) * plane.normal);
        friction(v, plane.normal, plane.friction * -pull * left, dot);
        x = x + (left / Real(2)) * Vec(before + v);
        return bounces;
      } else {  // nothing draws it back
        x = x + (left * v + (left * left / Real(2)) * a);
        v = v + left * a;
        return bounces;
      }
    }
  }
}

/// A plane that moves: where it is at some moment, and how fast.
template <class Vec, class Real>
struct MovingPlane {
  Plane<Vec, Real> plane;  ///< as it is seen from x: its level is a ball's radius, as a rule
  Vec x;                   ///< place of one of its points: if it turns, the one under the ball [m]
  Vec v;                   ///< velocity of that point [m/s]
};

/// One step of a point or a ball above a plane that moves and tilts: a lift, a deck, a belt.
///
/// Within the step the plane is taken to speed up evenly. What it carries is where it is at the
/// end, and what it doesn't meet flies as without it. Where the velocity of the plane jumps between
/// two steps, let `before` have the one with which it came: else what it carries may be within it
/// by g h^2 / 2 after the next step. It calls square roots.
///
/// @param x  place, advanced in place [m]
/// @param v  velocity, advanced in place [m/s]
/// @param a  acceleration throughout the step, of gravity as a rule [m/s^2]
/// @param h  step size [s]; not negative
/// @param before  the plane at the start of the step
/// @param now  the plane at its end, with the place and the velocity of the same point
/// @param dot  callable `(Vec, Vec) -> Real`, the dot product
/// @returns  how often it came up again
template <class Vec, class Real, class Dot>
int bounce_step(Vec& x, Vec& v, const Vec& a, Real h, const MovingPlane<Vec, Real>& before,
                const MovingPlane<Vec, Real>& now, Dot&& dot) {
  constexpr auto scale = [](auto s, const auto& y) -> decltype(s * y) { return s * y; };
  constexpr bool scales = std::is_invocable_r_v<Vec, decltype(scale), Real, Vec>;
  constexpr bool dots = std::is_invocable_r_v<Real, Dot&, const Vec&, const Vec&>;
  static_assert(scales,
                "h * x must be a Vec: 1/60.0f for floats; copy Maps; raylib lacks float * Vector3");
  static_assert(dots, "dot must be callable as Real(Vec, Vec)");
  static_assert(!std::is_integral_v<Real>, "h must be no integer");
  if constexpr (scales && dots) {
    if (!(h > Real(0))) return 0;
    // As it is seen from the plane.
    const Vec& normal = before.plane.normal;
    Vec place = x + Real(-1) * before.x, speed = v + Real(-1) * before.v;
    const Vec drawn = a + (Real(-1) / h) * Vec(now.v + Real(-1) * before.v);
    const Real pull = dot(drawn, normal);
    Real height = Real(dot(place, normal)) - before.plane.level;
    // What stands on it may be a rounding below, and jumps from there as well.
    const Real sunk = height < Real(0) ? -height : Real(0);
    height = height + sunk;
    if (!impact_plane(height, Real(dot(speed, normal)), pull, h).hit) {
      x = x + sunk * normal + (h * v + (h * h / Real(2)) * a);
      v = v + h * a;
      return 0;
    }
    const int bounces = bounce_step(place, speed, drawn, h, before.plane, dot);
    if (bounces == 0 && pull < Real(0)) {  // it rests, and goes on with the plane
      const Vec& up = now.plane.normal;
      place = place + Real(now.plane.level - Real(dot(place, up))) * up;
      speed = speed + Real(-Real(dot(speed, up))) * up;
    }
    x = place + now.x;
    v = speed + now.v;
    return bounces;
  }
}

}  // namespace shelf
