// SPDX-License-Identifier: MIT-0
#pragma once
#include "bounds.h"

namespace harness_bounds {

// At a cost of just a step, one of the special ones, a formula divides by zero. What is saved is
// less than a step.
constexpr double sixty_fourth = 1.0 / 64;
constexpr harness::Bounds saved{"saved", 0, 0.05}, length{"length", 0, 2, sixty_fourth},
    h{"h", 1e-3, 0.05, sixty_fourth}, most{"most", 1, 100}, draw{"draw", 1e-4, 0.2},
    cost{"cost", 0, 0.2, sixty_fourth};

}  // namespace harness_bounds

#ifdef GRADING

const harness::Wanted<int(double& saved, double length, double h, int most)> wanted_steps =
    steps_due;
const harness::Within within_steps{
    wanted_steps,
    {harness_bounds::saved, harness_bounds::length, harness_bounds::h, harness_bounds::most}};

const harness::Wanted<double(double draw, double cost, double h, int most)> wanted_frame =
    settled_frame;
const harness::Within within_frame{
    wanted_frame,
    {harness_bounds::draw, harness_bounds::cost, harness_bounds::h, harness_bounds::most}};

void answer(harness::Call& call) {
  double first = call.number();
  const double second = call.number(), h = call.number();
  const int most = call.whole_number();
  if (call.function() == 1) return call.answer(wanted_frame(first, second, h, most));
  call.answer(static_cast<double>(wanted_steps(first, second, h, most)));
  call.answer(first);
}

#endif
