// SPDX-License-Identifier: MIT-0
#pragma once

const harness::Wanted<void(Vec& x, Vec& v, double h, const Vec& hand, double omega, double zeta,
                           double strongest)>
    wanted = step;

void answer(harness::Call& call) {
  Vec x = call.vector(), v = call.vector();
  const double h = call.number();
  const Vec hand = call.vector();
  const double omega = call.number(), zeta = call.number(), strongest = call.number();
  wanted(x, v, h, hand, omega, zeta, strongest);
  call.answer(x);
  call.answer(v);
}
