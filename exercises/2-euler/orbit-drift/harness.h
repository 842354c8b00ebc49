// SPDX-License-Identifier: MIT-0
#pragma once

void (*const wanted_step)(Vec& x, Vec& v, double t, double h,
                          const Acceleration& acceleration) = step;
int (*const wanted_steps)(double growth) = steps_per_turn;

void answer(harness::Call& call) {
  if (call.function() == 0) {
    harness::run_steps(call, wanted_step);
  } else {
    call.answer(static_cast<double>(wanted_steps(call.number())));
  }
}
