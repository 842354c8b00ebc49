// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

/// One step of RK4.
inline void rk4(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  const Vec a1 = acceleration(x, v, t), v2 = v + (h / 2) * a1;
  const Vec a2 = acceleration(x + (h / 2) * v, v2, t + h / 2), v3 = v + (h / 2) * a2;
  const Vec a3 = acceleration(x + (h / 2) * v2, v3, t + h / 2), v4 = v + h * a3;
  const Vec a4 = acceleration(x + h * v3, v4, t + h);
  x += (h / 6) * (v + 2 * v2 + 2 * v3 + v4);
  v += (h / 6) * (a1 + 2 * a2 + 2 * a3 + a4);
}

/// Moves on in pairs of half steps of RK4 whose length is chosen by how far they end from a whole
/// one, until the time is over or a kept step is told to be the last.
/// @param stops  callable `(t, h, x_end, v_end) -> bool`: whether to stay where this step began
template <class Stops>
void fly_until(Vec& x, Vec& v, double t, double duration, double tolerance,
               const Acceleration& acceleration, Stops stops) {
  const double end = t + duration;
  double h = duration / 100;
  while (t < end) {
    const bool last = t + h >= end;
    const double step = last ? end - t : h;
    Vec x_whole = x, v_whole = v, x_halves = x, v_halves = v;
    rk4(x_whole, v_whole, t, step, acceleration);
    rk4(x_halves, v_halves, t, step / 2, acceleration);
    rk4(x_halves, v_halves, t + step / 2, step / 2, acceleration);
    const double estimate = std::max(length(x_halves - x_whole), length(v_halves - v_whole)) /
                            15;  // two half steps are sixteen times nearer
    if (estimate <= tolerance) {
      if (stops(t, step, x_halves, v_halves)) return;
      x = x_halves;
      v = v_halves;
      t = last ? end : t + step;
    }
    const double change = estimate > 0 ? 0.9 * std::pow(tolerance / estimate, 0.2) : 5;
    h = step * std::clamp(change, 0.2, 5.0);
  }
}

/// Moves on by a duration.
inline void fly(Vec& x, Vec& v, double t, double duration, double tolerance,
                const Acceleration& acceleration) {
  fly_until(x, v, t, duration, tolerance, acceleration,
            [](double, double, const Vec&, const Vec&) { return false; });
}

/// How far into a step the distance is least, by Newton's method: the change of x . v is v . v + x
/// . a.
inline double turn(const Vec& x, const Vec& v, double t, double step,
                   const Acceleration& acceleration) {
  double into = step / 2;
  for (int n = 0; n < 6; ++n) {
    Vec x_then = x, v_then = v;
    rk4(x_then, v_then, t, into / 2, acceleration);
    rk4(x_then, v_then, t + into / 2, into / 2, acceleration);
    const Vec a = acceleration(x_then, v_then, t + into);
    into -= dot(x_then, v_then) / (dot(v_then, v_then) + dot(x_then, a));
  }
  return into;
}

/// When a comet that comes in is nearest to the sun [s].
inline double nearest(Vec x, Vec v, double t, double duration, double tolerance,
                      const Acceleration& acceleration) {
  double begins = t, step = 0;
  fly_until(x, v, t, duration, tolerance, acceleration,
            [&](double time, double h, const Vec& x_end, const Vec& v_end) {
              begins = time;
              step = h;
              return dot(x_end, v_end) >= 0;
            });
  return begins + turn(x, v, begins, step, acceleration);
}
