// fails: below critical damping the limit is where the swing neither grows nor shrinks
// SPDX-License-Identifier: MIT-0
#pragma once
#include <complex>

#include "given.h"

// 2 zeta omega stands in the equation; the motion shrinks with zeta omega.
inline double stretch(double re, double im) {
  const std::complex<double> z(re, im);
  return std::abs(1.0 + z + z * z / 2.0 + z * z * z / 6.0 + z * z * z * z / 24.0);
}

inline double longest_step(double omega, double zeta) {
  const std::complex<double> root = std::sqrt(std::complex<double>(zeta * zeta - 1));
  const auto grows = [&](double h) {
    const auto fast = h * omega * (-2 * zeta - root), slow = h * omega * (-2 * zeta + root);
    return stretch(fast.real(), fast.imag()) > 1 || stretch(slow.real(), slow.imag()) > 1;
  };
  double stable = 0, unstable = 10 / omega;
  for (int halving = 0; halving < 50; ++halving) {
    const double middle = (stable + unstable) / 2;
    (grows(middle) ? unstable : stable) = middle;
  }
  return stable;
}
