// Fails: a spring far too stiff for the step puts the crate into the hand
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// Guesses the end with Euler's method and corrects once.
inline void step(Vec& x, Vec& v, double h, const Vec& hand, double omega, double zeta) {
  const Vec a = omega * omega * (hand - x) - 2 * zeta * omega * v;
  const Vec x_end = x + h * v, v_end = v + h * a;
  x += h * v_end;
  v += h * (omega * omega * (hand - x_end) - 2 * zeta * omega * v_end);
}
