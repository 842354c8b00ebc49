// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// Neighbouring half kicks are one kick: six kicks and five drifts.
inline void step(Vec& x, Vec& v, Vec& a, double t, double h, const Acceleration& acceleration) {
  constexpr double a1 = 0.41449077179437573714, a2 = 1 - 4 * a1;
  constexpr std::array drifts{a1, a1, a2, a1, a1};
  constexpr std::array kicks{a1 / 2, a1, (a1 + a2) / 2, (a2 + a1) / 2, a1, a1 / 2};
  double now = t;
  for (std::size_t i = 0; i < drifts.size(); ++i) {
    v += h * kicks[i] * a;
    x += h * drifts[i] * v;
    now += h * drifts[i];
    a = acceleration(x, v, now);
  }
  v += h * kicks.back() * a;
}
