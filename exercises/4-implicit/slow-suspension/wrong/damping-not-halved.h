// fails: each step takes the mean of both slopes
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// Without damping nobody can tell.
inline void step(double& x, double& v, double h, double omega, double zeta) {
  const double stiffness = omega * omega, damping = 2 * zeta * omega, half = h / 2;
  const double x_end = x + h * v;
  const double a = -stiffness * x - damping * v, a_end = -stiffness * x_end - damping * v;
  const double change = half * (a + a_end) / (1 + h * damping + half * half * stiffness);
  x = x + h * v + half * change;
  v = v + change;
}
