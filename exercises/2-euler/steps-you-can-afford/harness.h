// SPDX-License-Identifier: MIT-0
#pragma once
#include "bounds.h"

namespace harness_bounds {

constexpr harness::Bounds x{"x", 0, 20}, v{"v", 0, 8}, duration{"duration", 0.8, 2};

}  // namespace harness_bounds

#ifdef GRADING

// What is wanted is the error of a number of steps, which the judge draws.
const harness::Wanted<int(const Vec& x, const Vec& v, double duration, double wanted,
                          const Acceleration& acceleration)>
    wanted = steps_needed;
const harness::Within within{
    wanted,
    {harness_bounds::x, harness_bounds::v, harness_bounds::duration, harness::any, harness::any}};

// A run of one step: h is the duration, and t the wanted error.
void answer(harness::Call& call) {
  const harness::Run run(call);
  const int steps = wanted(run.x, run.v, run.h, run.t, run.acceleration);
  call.answer(Vec{static_cast<double>(steps), 0, 0});
  call.answer(Vec{});
}

#endif
