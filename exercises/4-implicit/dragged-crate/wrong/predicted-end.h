// Fails: with a strong hand the slope at the end leads back to the start
// Says: the end is guessed by a step of Euler's method, and not solved for
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// Guesses the end with Euler's method and corrects once.
inline void step(Vec& x, Vec& v, double h, const Vec& hand, double omega, double zeta,
                 double strongest) {
  const Vec a = omega * omega * (hand - x) - 2 * zeta * omega * v;
  const Vec x_end = x + h * v, v_end = v + h * a;
  Vec change = h * (omega * omega * (hand - x_end) - 2 * zeta * omega * v_end);
  if (length(change) > h * strongest) change = (h * strongest / length(change)) * change;
  x += h * v_end;
  v += change;
}
