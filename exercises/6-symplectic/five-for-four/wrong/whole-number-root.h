// fails: half the step leaves a sixteenth of the error
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// 1 / 3 is 0 in whole numbers, and anything to the power of 0 is 1.
/// One step of velocity Verlet.
/// @param a  acceleration at the start, replaced by the one at the end
inline void verlet(Vec& x, Vec& v, Vec& a, double t, double h, const Acceleration& acceleration) {
  v += h / 2 * a;
  x += h * v;
  a = acceleration(x, v, t + h);
  v += h / 2 * a;
}

inline void step(Vec& x, Vec& v, Vec& a, double t, double h, const Acceleration& acceleration) {
  const double outer = h / (4 - std::pow(4, 1 / 3)), middle = h - 4 * outer;
  for (const double part : {outer, outer, middle, outer, outer}) {
    verlet(x, v, a, t, part, acceleration);
    t += part;
  }
}
