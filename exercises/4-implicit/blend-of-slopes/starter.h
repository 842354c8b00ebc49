// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

/// What one step leaves of a velocity on the brake v' = -c v: the new one over the old, with sign.
/// @param theta  the share of the slope at the end, 0 to 1
/// @param ch  c times the step; positive
inline double left_of_brake(double theta, double ch) {
  return 0;
}

/// What one step leaves of the swing of an undamped spring: the new amplitude over the old.
/// @param homega  h omega; positive
inline double left_of_swing(double theta, double homega) {
  return 0;
}

/// The longest step at which a damped spring does not grow [s]; INFINITY if it never does.
/// @param omega  natural frequency [rad/s]; positive
/// @param zeta  damping ratio; 0 or more
inline double longest_step(double theta, double omega, double zeta) {
  return 0;
}

/// The least theta, from 0.5 to 1, with which a step on a brake leaves nothing negative.
/// @param ch  c times the step; positive
inline double least_theta(double ch) {
  return 0;
}
