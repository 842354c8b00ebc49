// SPDX-License-Identifier: MIT-0
// Ten steps of a method on a vector, and on each of its coordinates alone: the same numbers.
//
// A kind of vector says how one is made of numbers and how a number is read out of it. A vector
// itself has no more than a method may ask for.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <type_traits>

inline constexpr double omega = 2, zeta = 0.125;
inline constexpr double stiffness = omega * omega, damping = 2 * zeta * omega;

template <class Number, class Clock = double>
struct Scalar {
  using Vec = Number;
  using Real = Number;
  using Time = Clock;
  static constexpr int size = 1;
  static constexpr const char* name = "a number alone";
  static Vec make(const Real* from) { return from[0]; }
  static Real read(const Vec& x, int) { return x; }
};

// Solves the linear systems of the scene below, in which no coordinate sees another.
inline constexpr struct Divide {
  template <class Vec, class Time, class Real>
  bool operator()(const Vec&, const Vec&, Time, Real p, Real q, Vec& change) const {
    change = (Real(1) / (Real(1) - p * Real(stiffness) - q * Real(damping))) * change;
    return true;
  }
} divide;

// A spring with drag in each coordinate, pulled harder as time goes on, so that all arguments
// matter.
template <class Kind, class Solve>
struct Scene {
  using Vec = typename Kind::Vec;
  using Real = typename Kind::Real;
  using Time = typename Kind::Time;
  Solve& solve;

  template <class Position, class Velocity, class Clock>
  Vec operator()(const Position& x, const Velocity& v, Clock t) const {
    constexpr bool vectors = std::is_same_v<Position, Vec> && std::is_same_v<Velocity, Vec>;
    static_assert(vectors, "a method must hand on vectors: a reader's `const auto&` takes any");
    static_assert(std::is_same_v<Clock, Time>, "a clock of doubles must stay one");
    const Real pull[] = {1, 1, 1};
    return Real(-stiffness) * x + Real(-damping) * v + Real(t) * Kind::make(pull);
  }

  // The largest coordinate.
  Real norm(const Vec& x) const {
    Real largest = 0;
    for (int i = 0; i < Kind::size; ++i) largest = std::max(largest, std::abs(Kind::read(x, i)));
    return largest;
  }
};

template <class Vec>
struct State {
  Vec x, v;
};

template <class Kind, class Method, class Solve = const Divide>
State<typename Kind::Vec> after_ten_steps(Method method, State<typename Kind::Vec> s,
                                          Solve& solve = divide) {
  using Real = typename Kind::Real;
  using Time = typename Kind::Time;
  Scene<Kind, Solve> scene{solve};
  for (int n = 0; n < 10; ++n) method(s.x, s.v, Time(0.25 + n * 0.1), Real(0.1), scene);
  return s;
}

// Ten steps of at most 64 operations, each rounding a number below 8.
template <class Real>
constexpr double rounding() {
  return 10 * 64 * 8 * (std::is_same_v<Real, float> ? 0x1p-24 : 0x1p-53);
}

// How many coordinates of a vector differ from what its numbers do alone.
template <class Kind, class Method, class Solve = const Divide>
int differences(const char* method_name, Method method, double tolerance = 0,
                Solve& solve = divide) {
  using Real = typename Kind::Real;
  const Real x[] = {1, -3, 4}, v[] = {2, 0.5, 0.25};
  const auto all = after_ten_steps<Kind>(method, {Kind::make(x), Kind::make(v)}, solve);
  int wrong = 0;
  for (int i = 0; i < Kind::size; ++i) {
    const auto one = after_ten_steps<Scalar<Real, typename Kind::Time>>(method, {x[i], v[i]});
    const Real x_end = Kind::read(all.x, i), v_end = Kind::read(all.v, i);
    const double x_off = double(std::abs(x_end - one.x)), v_off = double(std::abs(v_end - one.v));
    if (x_off <= tolerance && v_off <= tolerance) continue;
    std::printf("%s on %s, coordinate %d: x %.17g, v %.17g; alone x %.17g, v %.17g\n", method_name,
                Kind::name, i, double(x_end), double(v_end), double(one.x), double(one.v));
    ++wrong;
  }
  return wrong;
}

// Doubles are what all else is compared with, so they must do something; floats do the same up to
// rounding, with a clock of either type.
template <class Method>
int numbers_wrong(const char* name, Method method) {
  const auto exact = after_ten_steps<Scalar<double>>(method, {1, 2});
  const auto rounded = after_ten_steps<Scalar<float>>(method, {1, 2});
  const auto clocked = after_ten_steps<Scalar<float, float>>(method, {1, 2});
  const double tolerance = rounding<float>();
  const auto near = [&](const State<float>& s) {
    return std::abs(double(s.x) - exact.x) < tolerance &&
           std::abs(double(s.v) - exact.v) < tolerance;
  };
  const bool moved = std::abs(exact.x - 1) > tolerance && std::abs(exact.v - 2) > tolerance;
  if (moved && near(rounded) && near(clocked)) return 0;
  std::printf("%s: x %.9g on double, %.9g on float, %.9g with a clock of floats, too\n", name,
              exact.x, double(rounded.x), double(clocked.x));
  std::printf("%s: v %.9g on double, %.9g on float, %.9g with a clock of floats, too\n", name,
              exact.v, double(rounded.v), double(clocked.v));
  return 1;
}
