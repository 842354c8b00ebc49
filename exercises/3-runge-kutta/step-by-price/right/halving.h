// SPDX-License-Identifier: MIT-0
#pragma once
#include <optional>

#include "given.h"

inline void rk4(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  const Vec a1 = acceleration(x, v, t), v2 = v + (h / 2) * a1;
  const Vec a2 = acceleration(x + (h / 2) * v, v2, t + h / 2), v3 = v + (h / 2) * a2;
  const Vec a3 = acceleration(x + (h / 2) * v2, v3, t + h / 2), v4 = v + h * a3;
  const Vec a4 = acceleration(x + h * v3, v4, t + h);
  x += (h / 6) * (v + 2 * v2 + 2 * v3 + v4);
  v += (h / 6) * (a1 + 2 * a2 + 2 * a3 + a4);
}

// How far into a piece of a flight its distance turns: guess, fly there, and guess from there.
inline double turn(Vec x, Vec v, double t, const Acceleration& acceleration) {
  double into = 0;
  for (int n = 0; n < 6; ++n) {
    const double more = -dot(x, v) / (dot(v, v) + dot(x, acceleration(x, v, t + into)));
    rk4(x, v, t + into, more, acceleration);
    into += more;
  }
  return into;
}

// No step size at all: a flight that is too wrong as one step is two flights of half the time.
// Returns when a comet turns, if it is to stop there and has come that far; else nothing.
inline std::optional<double> pieces(Vec& x, Vec& v, double t, double duration, double tolerance,
                                    const Acceleration& acceleration, bool to_the_pass) {
  Vec x_whole = x, v_whole = v, x_halves = x, v_halves = v;
  rk4(x_whole, v_whole, t, duration, acceleration);
  rk4(x_halves, v_halves, t, duration / 2, acceleration);
  rk4(x_halves, v_halves, t + duration / 2, duration / 2, acceleration);
  const Vec dx = (1 / 15.0) * (x_halves - x_whole), dv = (1 / 15.0) * (v_halves - v_whole);
  if (length(dx) <= tolerance && length(dv) <= tolerance) {
    if (to_the_pass && dot(x_halves, v_halves) > 0) return t + turn(x, v, t, acceleration);
    x = x_halves + dx;
    v = v_halves + dv;
    return std::nullopt;
  }
  const auto early = pieces(x, v, t, duration / 2, tolerance, acceleration, to_the_pass);
  if (early) return early;
  return pieces(x, v, t + duration / 2, duration / 2, tolerance, acceleration, to_the_pass);
}

inline void fly(Vec& x, Vec& v, double t, double duration, double tolerance,
                const Acceleration& acceleration) {
  pieces(x, v, t, duration, tolerance, acceleration, false);
}

inline double nearest(Vec x, Vec v, double t, double duration, double tolerance,
                      const Acceleration& acceleration) {
  return pieces(x, v, t, duration, tolerance, acceleration, true).value_or(t + duration);
}
