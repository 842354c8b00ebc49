// fails: a spring that is switched off lets the crate go on
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// The form of a soft constraint, without the question whether there is a spring at all: 0 / 0.
inline void step(Vec& x, Vec& v, double h, const Vec& hand, double omega, double zeta) {
  const double damping_and_step = 2 * zeta + h * omega;
  const double stiff = h * omega * damping_and_step;
  const double bias_rate = omega / damping_and_step;
  v -= stiff / (1 + stiff) * (v + bias_rate * (x - hand));
  x += h * v;
}
