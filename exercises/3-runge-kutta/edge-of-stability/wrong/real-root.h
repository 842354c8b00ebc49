// Fails: from critical damping on the faster of two motions sets the limit
// Says: the root of a number below zero is no number, and with it no step grows
// SPDX-License-Identifier: MIT-0
#pragma once
#include <complex>

#include "given.h"

// The root of a negative number is not a number, and no comparison with that holds.
inline double stretch(double re, double im) {
  const std::complex<double> z(re, im);
  return std::abs(1.0 + z + z * z / 2.0 + z * z * z / 6.0 + z * z * z * z / 24.0);
}

inline double longest_step(double omega, double zeta) {
  double stable = 0, unstable = 10 / omega;
  for (int halving = 0; halving < 50; ++halving) {
    const double h = (stable + unstable) / 2;
    const double swing = h * omega * std::sqrt(1 - zeta * zeta);
    (stretch(-h * omega * zeta, swing) > 1 ? unstable : stable) = h;
  }
  return stable;
}
