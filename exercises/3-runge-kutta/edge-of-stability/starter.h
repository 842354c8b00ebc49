// SPDX-License-Identifier: MIT-0
#pragma once
#include <complex>

#include "given.h"

/// By how much one step of RK4 multiplies the size of a motion w' = lambda w.
/// @param re  real part of h lambda, less than zero where the motion is damped
/// @param im  imaginary part of h lambda
inline double stretch(double re, double im) {
  return 0;
}

/// The longest step with which RK4 lets no motion of a damped spring grow [s].
/// @param omega  natural frequency [rad/s], above zero
/// @param zeta  damping ratio, not below zero; 1 is critical
inline double longest_step(double omega, double zeta) {
  return 0;
}
