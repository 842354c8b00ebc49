// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

inline double left_of_brake(double theta, double ch) {
  const double c_start = ch - theta * ch;
  return 1 / (1 + theta * ch) - c_start / (1 + theta * ch);
}

inline double left_of_swing(double theta, double homega) {
  const double square = homega * homega;
  const double start = 1 + (1 - theta) * (1 - theta) * square, end = 1 + theta * theta * square;
  return std::sqrt(start / end);
}

inline double longest_step(double theta, double omega, double zeta) {
  if (!(theta < 0.5)) return INFINITY;
  const double share = 1 - 2 * theta;
  if (zeta <= 1) return 2 * zeta / omega / share;
  const double fast = omega * zeta + omega * std::sqrt((zeta - 1) * (zeta + 1));
  return 2 / (fast * share);
}

inline double least_theta(double ch) {
  const double theta = (ch - 1) / ch;
  if (theta < 0.5) return 0.5;
  return theta;
}
