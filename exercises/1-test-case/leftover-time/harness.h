// SPDX-License-Identifier: MIT-0
#pragma once

int (*const wanted_steps)(double& saved, double length, double h) = steps_due;
double (*const wanted_blend)(double saved, double h) = blend;

// The step, then the frames; for each of them the steps due and the blend.
void answer(harness::Call& call) {
  const double h = call.number();
  const int frames = call.whole_number();
  double saved = 0;
  for (int n = 0; n < frames; ++n) {
    call.answer(static_cast<double>(wanted_steps(saved, call.number(), h)));
    call.answer(wanted_blend(saved, h));
  }
}
