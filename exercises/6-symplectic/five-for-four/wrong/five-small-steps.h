// fails: half the step leaves a sixteenth of the error
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// Five steps of a fifth: closer than one, and still order two.
/// One step of velocity Verlet.
/// @param a  acceleration at the start, replaced by the one at the end
inline void verlet(Vec& x, Vec& v, Vec& a, double t, double h, const Acceleration& acceleration) {
  v += h / 2 * a;
  x += h * v;
  a = acceleration(x, v, t + h);
  v += h / 2 * a;
}

inline void step(Vec& x, Vec& v, Vec& a, double t, double h, const Acceleration& acceleration) {
  for (int n = 0; n < 5; ++n) verlet(x, v, a, t + n * h / 5, h / 5, acceleration);
}
