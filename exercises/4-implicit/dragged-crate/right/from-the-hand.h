// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// As seen from the hand it is the chapter's spring.
template <class Real>
void spring(Vec& off, Vec& v, Real h, Real omega, Real zeta) {
  const Real left = Real(1) / (Real(1) + h * omega * (Real(2) * zeta + h * omega));
  v = left * (v + (-h * omega * omega) * off);
  off = off + h * v;
}

inline Vec at_most(double most, const Vec& change) {
  const double size = length(change);
  return size > most ? most / size * change : change;
}

inline void step(Vec& x, Vec& v, double h, const Vec& hand, double omega, double zeta,
                 double strongest) {
  Vec off = x - hand, strong = v;
  spring(off, strong, h, omega, zeta);
  v += at_most(h * strongest, strong - v);
  x += h * v;
}
