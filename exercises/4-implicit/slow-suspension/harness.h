// SPDX-License-Identifier: MIT-0
#pragma once

const harness::Wanted<void(double& x, double& v, double h, double omega, double zeta)> wanted =
    step;

const harness::Wanted<double(double omega, double h)> wanted_told = told;

void answer(harness::Call& call) {
  if (call.function() == 1) {
    const double omega = call.number();
    return call.answer(wanted_told(omega, call.number()));
  }
  double x = call.number(), v = call.number();
  const double h = call.number(), omega = call.number(), zeta = call.number();
  const int steps = call.whole_number();
  for (int n = 0; n < steps; ++n) {
    wanted(x, v, h, omega, zeta);
    call.answer(x);
    call.answer(v);
  }
}
