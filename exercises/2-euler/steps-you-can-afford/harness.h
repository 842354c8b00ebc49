// SPDX-License-Identifier: MIT-0
#pragma once

const harness::Wanted<int(const Vec& x, const Vec& v, double duration, double wanted,
                          const Acceleration& acceleration)>
    wanted = steps_needed;

// A run of one step: h is the duration, and t the wanted error.
void answer(harness::Call& call) {
  const harness::Run run(call);
  const int steps = wanted(run.x, run.v, run.h, run.t, run.acceleration);
  call.answer(Vec{static_cast<double>(steps), 0, 0});
  call.answer(Vec{});
}
