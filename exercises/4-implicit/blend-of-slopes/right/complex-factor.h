// SPDX-License-Identifier: MIT-0
#pragma once
#include <complex>

#include "given.h"

// One factor for everything, and the condition of the hint for each of the spring's two rates.
using Rate = std::complex<double>;

inline Rate factor(double theta, Rate z) {
  return (1.0 + (1 - theta) * z) / (1.0 - theta * z);
}

inline double left_of_brake(double theta, double ch) {
  return factor(theta, -ch).real();
}

inline double left_of_swing(double theta, double homega) {
  return std::abs(factor(theta, Rate(0, homega)));
}

inline double longest(double theta, Rate lambda) {
  return -2 * lambda.real() / ((1 - 2 * theta) * std::norm(lambda));
}

inline double longest_step(double theta, double omega, double zeta) {
  if (theta >= 0.5) return std::numeric_limits<double>::infinity();
  const Rate root = std::sqrt(Rate(zeta * zeta - 1));
  return std::min(longest(theta, omega * (-zeta + root)), longest(theta, omega * (-zeta - root)));
}

inline double least_theta(double ch) {
  return ch < 2 ? 0.5 : (ch - 1) / ch;
}
