// Fails: the shuttle lands eighty times nearer than RK4 in equal steps
// Says: no two questions are for one time, as in velocity Verlet, which asks once a step and has order two; an orbit this smooth rewards a higher order
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// Steps that fit the orbit, and a method of order two, which loses half of that when they change.
inline void fly(Vec& x, Vec& v, double t, double seconds, const Acceleration& acceleration) {
  const double end = t + seconds;
  Vec a = acceleration(x, v, t);
  while (t < end) {
    const double h = std::min(0.03 * std::pow(length(x), 1.5), end - t);
    v += h / 2 * a;
    x += h * v;
    t += h;
    a = acceleration(x, v, t);
    v += h / 2 * a;
  }
}
