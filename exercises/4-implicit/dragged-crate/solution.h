// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

/// One step of backward Euler on a damped spring to a hand that is only so strong.
inline void step(Vec& x, Vec& v, double h, const Vec& hand, double omega, double zeta,
                 double strongest) {
  const double angle = h * omega;
  const Vec meant = (v + angle * omega * (hand - x)) / (1 + 2 * zeta * angle + angle * angle);
  Vec change = meant - v;
  if (length(change) > h * strongest) change = (h * strongest / length(change)) * change;
  v = v + change;
  x = x + h * v;
}
