// fails: an undamped spring keeps what the factor says
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// The energy is the square of the swing.
inline double left_of_brake(double theta, double ch) {
  return (1 - (1 - theta) * ch) / (1 + theta * ch);
}

inline double left_of_swing(double theta, double homega) {
  const double start = (1 - theta) * homega, end = theta * homega;
  return (1 + start * start) / (1 + end * end);
}

inline double longest_step(double theta, double omega, double zeta) {
  if (theta >= 0.5) return INFINITY;
  const double rate = zeta > 1 ? 1 / (zeta + std::sqrt(zeta * zeta - 1)) : zeta;
  return 2 * rate / (omega * (1 - 2 * theta));
}

inline double least_theta(double ch) {
  return std::max(0.5, 1 - 1 / ch);
}
