// SPDX-License-Identifier: MIT-0
#pragma once

const harness::Wanted<void(double& x, double& v, double target, double omega, double h)> wanted =
    settle;

// Start, frequency, how many frames, and each frame's target and length; answers after each.
void answer(harness::Call& call) {
  double x = call.number(), v = call.number();
  const double omega = call.number();
  const int frames = call.whole_number();
  for (int n = 0; n < frames; ++n) {
    const double target = call.number(), h = call.number();
    wanted(x, v, target, omega, h);
    call.answer(x);
    call.answer(v);
  }
}
