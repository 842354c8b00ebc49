// SPDX-License-Identifier: MIT-0
#pragma once

const harness::Wanted<void(double& x, double& v, double h, double omega, double zeta)> wanted =
    step;

void answer(harness::Call& call) {
  double x = call.number(), v = call.number();
  const double h = call.number(), omega = call.number(), zeta = call.number();
  const int steps = call.whole_number();
  for (int n = 0; n < steps; ++n) {
    wanted(x, v, h, omega, zeta);
    call.answer(x);
    call.answer(v);
  }
}
