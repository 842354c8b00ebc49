// SPDX-License-Identifier: MIT-0
#pragma once
#include "bounds.h"

namespace harness_bounds {

constexpr harness::Bounds growth{"growth", 0.001, 4};

}  // namespace harness_bounds

#ifdef GRADING

const harness::Wanted<void(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration)>
    wanted_step = step;
const harness::Wanted<int(double growth)> wanted_steps = steps_per_turn;
const harness::Within within_steps{wanted_steps, {harness_bounds::growth}};

void answer(harness::Call& call) {
  if (call.function() == 0) {
    harness::run_steps(call, wanted_step);
  } else {
    call.answer(static_cast<double>(wanted_steps(call.number())));
  }
}

#endif
