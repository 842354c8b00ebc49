// fails: without damping the step may be as long as the chapter says
// SPDX-License-Identifier: MIT-0
#pragma once
#include <complex>

#include "given.h"

// What the motion itself does, not what the method makes of it.
inline double stretch(double re, double im) {
  const std::complex<double> z(re, im);
  return std::abs(std::exp(z));
}

inline double longest_step(double omega, double zeta) {
  const std::complex<double> root = std::sqrt(std::complex<double>(zeta * zeta - 1));
  const auto grows = [&](double h) {
    const auto fast = h * omega * (-zeta - root), slow = h * omega * (-zeta + root);
    return stretch(fast.real(), fast.imag()) > 1 || stretch(slow.real(), slow.imag()) > 1;
  };
  double stable = 0, unstable = 10 / omega;
  for (int halving = 0; halving < 50; ++halving) {
    const double middle = (stable + unstable) / 2;
    (grows(middle) ? unstable : stable) = middle;
  }
  return stable;
}
