// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

constexpr int budget = 1200;
constexpr int spent = 900;  // a quarter is kept for emergencies

inline void rk4(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  const Vec a1 = acceleration(x, v, t);
  const Vec v2 = v + h / 2 * a1, a2 = acceleration(x + h / 2 * v, v2, t + h / 2);
  const Vec v3 = v + h / 2 * a2, a3 = acceleration(x + h / 2 * v2, v3, t + h / 2);
  const Vec v4 = v + h * a3, a4 = acceleration(x + h * v3, v4, t + h);
  x += h / 6 * (v + 2 * v2 + 2 * v3 + v4);
  v += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
}

// A planet's pull sets the pace of an orbit: steps as long as the distance to the power of 3/2.
inline double pace(const Vec& x) {
  return std::pow(length(x), 1.5);
}

/// Flies with steps of so many paces; ends at the very second.
/// @return how many steps it took
inline int fly_by(double paces, Vec& x, Vec& v, double t, double seconds,
                  const Acceleration& acceleration) {
  const double end = t + seconds;
  int steps = 0;
  for (bool there = false; !there; ++steps) {
    const double h = std::min(paces * pace(x), end - t);
    there = h == end - t;
    rk4(x, v, t, h, acceleration);
    t += h;
  }
  return steps;
}

/// A rough flight counts the steps; the real one takes as many as are left of what it may spend.
inline void fly(Vec& x, Vec& v, double t, double seconds, const Acceleration& acceleration) {
  Vec x_rough = x, v_rough = v;
  constexpr double rough = 0.3;
  const int taken = fly_by(rough, x_rough, v_rough, t, seconds, acceleration);
  const int left = spent / 4 - taken;
  fly_by(rough * taken / (0.96 * left), x, v, t, seconds, acceleration);
}
