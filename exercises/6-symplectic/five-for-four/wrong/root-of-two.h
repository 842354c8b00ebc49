// fails: half the step leaves a sixteenth of the error
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// Yoshida's root with Suzuki's four.
/// One step of velocity Verlet.
/// @param a  acceleration at the start, replaced by the one at the end
inline void verlet(Vec& x, Vec& v, Vec& a, double t, double h, const Acceleration& acceleration) {
  v += h / 2 * a;
  x += h * v;
  a = acceleration(x, v, t + h);
  v += h / 2 * a;
}

inline void step(Vec& x, Vec& v, Vec& a, double t, double h, const Acceleration& acceleration) {
  const double outer = h / (4 - std::cbrt(2)), middle = h - 4 * outer;
  for (const double part : {outer, outer, middle, outer, outer}) {
    verlet(x, v, a, t, part, acceleration);
    t += part;
  }
}
