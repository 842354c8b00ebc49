// fails: without a damper its energy stays for a minute
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// SOFA's implicit solver had this factor, h^2 / 2 for h^2 / 4, in its trapezoid option
// (sofa-framework/sofa, issue 5140).
inline void step(double& x, double& v, double h, double omega, double zeta) {
  const double stiffness = omega * omega, damping = 2 * zeta * omega, half = h / 2;
  const double x_end = x + h * v;
  const double a = -stiffness * x - damping * v, a_end = -stiffness * x_end - damping * v;
  const double change = half * (a + a_end) / (1 + half * damping + half * h * stiffness);
  x = x + h * v + half * change;
  v = v + change;
}
