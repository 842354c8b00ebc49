// SPDX-License-Identifier: MIT-0
#pragma once
#include "bounds.h"

namespace harness_bounds {

constexpr harness::Bounds from{"from", 0, 1000}, target{"target", 0, 1000}, runner{"runner", 0, 12},
    a{"a", 0, 30}, time{"time", 0.05, 60, 1};

}  // namespace harness_bounds

#ifdef GRADING

const harness::Wanted<Vec(const Vec& from, const Vec& target, const Vec& runner, const Vec& a,
                          double time)>
    wanted = throw_velocity;
const harness::Within within{wanted,
                             {harness_bounds::from, harness_bounds::target, harness_bounds::runner,
                              harness_bounds::a, harness_bounds::time}};

void answer(harness::Call& call) {
  const Vec from = call.vector(), target = call.vector(), runner = call.vector(), a = call.vector();
  call.answer(wanted(from, target, runner, a, call.number()));
}

#endif
