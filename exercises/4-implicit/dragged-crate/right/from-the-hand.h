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

inline void step(Vec& x, Vec& v, double h, const Vec& hand, double omega, double zeta) {
  Vec off = x - hand;
  spring(off, v, h, omega, zeta);
  x = hand + off;
}
