// SPDX-License-Identifier: MIT-0
#pragma once
#include "bounds.h"

namespace harness_bounds {

constexpr harness::Bounds length{"length", 0, 2}, pace{"pace", 0, 4, 1}, h{"h", 1e-3, 0.1};

}  // namespace harness_bounds

#ifdef GRADING

// What is saved is what the student's own steps have left.
const harness::Wanted<int(double& saved, double length, double pace, double h)> wanted_steps =
    steps_due;
const harness::Within within_steps{
    wanted_steps, {harness::any, harness_bounds::length, harness_bounds::pace, harness_bounds::h}};

const harness::Wanted<double(double saved, double h)> wanted_blend = blend;
const harness::Within within_blend{wanted_blend, {harness::any, harness_bounds::h}};

// The step, then the frames, each with its pace; for each of them the steps due, the blend, and
// what is saved.
void answer(harness::Call& call) {
  const double h = call.number();
  const int frames = call.whole_number();
  double saved = 0;
  for (int n = 0; n < frames; ++n) {
    const double length = call.number(), pace = call.number();
    call.answer(static_cast<double>(wanted_steps(saved, length, pace, h)));
    call.answer(wanted_blend(saved, h));
    call.answer(saved);
  }
}

#endif
