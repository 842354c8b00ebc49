// SPDX-License-Identifier: MIT-0
#pragma once
#include "bounds.h"

namespace harness_bounds {

constexpr harness::Bounds h{"h", 0.001, 0.1}, omega{"omega", 0, 1e7}, zeta{"zeta", 0, 10, 1},
    strongest{"strongest", 0, 1e9}, place{"x", 0, 100}, velocity{"v", 0, 100}, hand{"hand", 0, 100};

}  // namespace harness_bounds

#ifdef GRADING

const harness::Wanted<void(Vec& x, Vec& v, double h, const Vec& hand, double omega, double zeta,
                           double strongest)>
    wanted = step;
const harness::Within within_wanted{
    wanted,
    {harness_bounds::place, harness_bounds::velocity, harness_bounds::h, harness_bounds::hand,
     harness_bounds::omega, harness_bounds::zeta, harness_bounds::strongest}};

void answer(harness::Call& call) {
  Vec x = call.vector(), v = call.vector();
  const double h = call.number();
  const Vec hand = call.vector();
  const double omega = call.number(), zeta = call.number(), strongest = call.number();
  wanted(x, v, h, hand, omega, zeta, strongest);
  call.answer(x);
  call.answer(v);
}

#endif
