// SPDX-License-Identifier: MIT-0
#pragma once
#include "bounds.h"

namespace harness_bounds {

constexpr harness::Bounds camera{"camera", 0, 1000}, target{"target", 0, 1000},
    part{"part", 0.001, 0.99}, fastest{"fastest", 0.1, 1e6}, frame{"frame", 0, 2, 1.0 / 60};

}  // namespace harness_bounds

#ifdef GRADING

const harness::Wanted<Vec(const Vec& camera, const Vec& target, double part, double fastest,
                          double frame)>
    wanted = follow;
const harness::Within within{wanted,
                             {harness_bounds::camera, harness_bounds::target, harness_bounds::part,
                              harness_bounds::fastest, harness_bounds::frame}};

void answer(harness::Call& call) {
  const Vec camera = call.vector(), target = call.vector();
  const double part = call.number(), fastest = call.number();
  call.answer(wanted(camera, target, part, fastest, call.number()));
}

#endif
