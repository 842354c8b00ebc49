// Fails: each step takes the mean of both slopes
// Says: the energy stays, and the damper should have taken some of it
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// Scales the velocity until the energy is that of the start, and so takes the damping away, too.
inline void step(double& x, double& v, double h, double omega, double zeta) {
  const double energy = omega * omega * x * x + v * v;
  const double stiffness = omega * omega, damping = 2 * zeta * omega, half = h / 2;
  const double x_end = x + h * v;
  const double a = -stiffness * x - damping * v, a_end = -stiffness * x_end - damping * v;
  const double change = half * (a + a_end) / (1 + half * damping + half * h * stiffness);
  x = x + h * v + half * change;
  v = v + change;
  const double scale = std::sqrt(energy / (omega * omega * x * x + v * v));
  x = scale * x;
  v = scale * v;
}

inline double told(double omega, double h) {
  return 2 / h * std::tan(omega * h / 2);
}
