// SPDX-License-Identifier: MIT-0
#pragma once

const harness::Wanted<int(double& saved, double length, double pace, double h)> wanted_steps =
    steps_due;
const harness::Wanted<double(double saved, double h)> wanted_blend = blend;

// The step, then the frames, each with its pace; for each of them the steps due and the blend.
void answer(harness::Call& call) {
  const double h = call.number();
  const int frames = call.whole_number();
  double saved = 0;
  for (int n = 0; n < frames; ++n) {
    const double length = call.number(), pace = call.number();
    call.answer(static_cast<double>(wanted_steps(saved, length, pace, h)));
    call.answer(wanted_blend(saved, h));
  }
}
