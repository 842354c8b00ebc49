// SPDX-License-Identifier: MIT-0
/// @file
/// Two masses with a damped spring between them, thrown through empty space.
#pragma once
#include "integrate/linear_damping.h"
#include "integrate/symplectic_euler.h"
#include "measure/record.h"
#include "shadow.h"

/// A number for each of the two masses.
struct Two {
  double a = 0, b = 0;

  friend constexpr Two operator+(Two one, Two other) { return {one.a + other.a, one.b + other.b}; }
  friend constexpr Two operator*(double factor, Two two) {
    return {factor * two.a, factor * two.b};
  }
};

/// Two masses on a line, and the spring between them; without its damper, which a step adds.
struct Pair {
  Two mass{1, 1};         ///< [kg]
  double stiffness = 50;  ///< [N/m]
  double damper = 5;      ///< force per relative speed [kg/s]

  /// One over the one mass and one over the other [1/kg].
  double lightness() const { return 1 / mass.a + 1 / mass.b; }

  /// The acceleration of the spring; how far apart the masses are at rest does not matter.
  Two operator()(const Two& x, const Two&, double) const {
    const double force = stiffness * (x.b - x.a);
    return {force / mass.a, -force / mass.b};
  }

  /// The speed that both have in common [m/s].
  double common_speed(const Two& v) const {
    return (mass.a * v.a + mass.b * v.b) / (mass.a + mass.b);
  }
};

/// A step that divides the relative velocity.
inline void divide_between(Two& x, Two& v, double t, double h, const Pair& pair) {
  // [between]
  v = v + h * pair(x, v, t);
  const double relative = v.b - v.a;
  const double braked = relative / (1 + h * pair.damper * pair.lightness());
  const double impulse = (braked - relative) / pair.lightness();
  v.a = v.a - impulse / pair.mass.a;
  v.b = v.b + impulse / pair.mass.b;
  x = x + h * v;
  // [between]
}

/// A step that divides both velocities, as if the damper were drag against the air.
inline void divide_each(Two& x, Two& v, double t, double h, const Pair& pair) {
  integrate::linear_damping_implicit_last(x, v, t, h, pair.damper / pair.mass.a, pair);
}

/// The speed that two thrown masses have in common after a second [m/s].
template <class Step>
double speed_of_thrown(Step step, const Pair& pair) {
  Two x{0, 0.1}, v{10, 10};
  for (int n = 0; n < 60; ++n) step(x, v, n * frame, frame, pair);
  return pair.common_speed(v);
}

inline void thrown_pair(measure::Record& record) {
  record.number("thrown-between", speed_of_thrown(divide_between, Pair{}), 2, "m/s");
  record.number("thrown-each", speed_of_thrown(divide_each, Pair{}), 1, "m/s");
}
