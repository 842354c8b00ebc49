// fails: just below the longest step a damped spring shrinks, just above it grows
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// Past one half the formula turns negative.
inline double left_of_brake(double theta, double ch) {
  return (1 - (1 - theta) * ch) / (1 + theta * ch);
}

inline double left_of_swing(double theta, double homega) {
  return std::hypot(1, (1 - theta) * homega) / std::hypot(1, theta * homega);
}

inline double longest_step(double theta, double omega, double zeta) {
  const double rate = zeta > 1 ? 1 / (zeta + std::sqrt(zeta * zeta - 1)) : zeta;
  return 2 * rate / (omega * (1 - 2 * theta));
}

inline double least_theta(double ch) {
  return std::max(0.5, 1 - 1 / ch);
}
