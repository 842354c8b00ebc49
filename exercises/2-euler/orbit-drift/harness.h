// SPDX-License-Identifier: MIT-0
#pragma once

const harness::Wanted<void(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration)>
    wanted_step = step;
const harness::Wanted<int(double growth)> wanted_steps = steps_per_turn;

void answer(harness::Call& call) {
  if (call.function() == 0) {
    harness::run_steps(call, wanted_step);
  } else {
    call.answer(static_cast<double>(wanted_steps(call.number())));
  }
}
