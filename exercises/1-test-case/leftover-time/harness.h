// SPDX-License-Identifier: MIT-0
#pragma once
#include "bounds.h"

namespace harness_bounds {

// What is saved is less than a step, and the longest that is asked is hardly less.
constexpr harness::Bounds saved{"saved", 0, 0.1}, length{"length", 0, 2}, pace{"pace", 0, 4, 1},
    h{"h", 1e-3, 0.1};

}  // namespace harness_bounds

#ifdef GRADING

const harness::Wanted<int(double& saved, double length, double pace, double h)> wanted_steps =
    steps_due;
const harness::Within within_steps{
    wanted_steps,
    {harness_bounds::saved, harness_bounds::length, harness_bounds::pace, harness_bounds::h}};

const harness::Wanted<double(double saved, double h)> wanted_blend = blend;
const harness::Within within_blend{wanted_blend, {harness_bounds::saved, harness_bounds::h}};

// What is saved, the step, then the frames, each with its pace; for each of them the steps due, the
// blend, and what is saved.
void answer(harness::Call& call) {
  double saved = call.number();
  const double h = call.number();
  const int frames = call.whole_number();
  for (int n = 0; n < frames; ++n) {
    const double length = call.number(), pace = call.number();
    call.answer(static_cast<double>(wanted_steps(saved, length, pace, h)));
    call.answer(wanted_blend(saved, h));
    call.answer(saved);
  }
}

#endif
