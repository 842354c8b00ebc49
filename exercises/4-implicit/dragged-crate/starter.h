// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

/// One step of backward Euler on a damped spring to a hand that is only so strong.
/// @param x  position of the crate [m], advanced in place
/// @param v  velocity of the crate [m/s], advanced in place
/// @param h  step size [s]
/// @param hand  where the hand is at the end of the step [m]
/// @param omega  natural frequency of the spring [rad/s]; may be 0
/// @param zeta  damping ratio; may be 0
/// @param strongest  the largest acceleration that the hand can give to the crate [m/s^2]; may be 0
inline void step(Vec& x, Vec& v, double h, const Vec& hand, double omega, double zeta,
                 double strongest) {
  // First the velocity that the spring asks for; then how much of the change the hand can give.
}
