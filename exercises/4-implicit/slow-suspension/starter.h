// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

/// One step of the trapezoid rule on a damped spring, x'' = -omega^2 x - 2 zeta omega x'.
/// @param x  how far the spring is stretched [m], advanced in place
/// @param v  its rate [m/s], advanced in place
/// @param h  step size [s]; a negative step goes back in time
/// @param omega  natural frequency [rad/s]; positive
/// @param zeta  damping ratio; may be 0
inline void step(double& x, double& v, double h, double omega, double zeta) {
  const double stiffness = omega * omega, damping = 2 * zeta * omega, half = h / 2;
  const double x_end = x + h * v;
  const double a = -stiffness * x - damping * v, a_end = -stiffness * x_end - damping * v;
  const double matrix = 1 + half * damping + half * h * stiffness;
  const double change = half * (a + a_end) / matrix;
  x = x + h * v + half * change;
  v = v + change;
}

/// What to hand over as omega, so that an undamped spring swings at the rate that is wanted.
/// @param omega  the rate that is wanted [rad/s]; omega h is below pi
/// @param h  step size [s], above 0
/// @returns  the omega that the step is told [rad/s]
inline double told(double omega, double h) {
  return omega;  // your line
}
