// SPDX-License-Identifier: MIT-0
#pragma once
#include "bounds.h"

namespace harness_bounds {

constexpr harness::Bounds shortest{"shortest", 0, 100}, longest{"longest", 0.01, 100},
    inverse{"inverse", 0, 100, 1}, place{"a", 0, 200};

}  // namespace harness_bounds

#ifdef GRADING

const harness::Wanted<void(Vec& a, Vec& b, double shortest, double longest, double inverse_a,
                           double inverse_b)>
    wanted = pull;
const harness::Within within_wanted{
    wanted,
    {harness_bounds::place, harness::any, harness_bounds::shortest, harness_bounds::longest,
     harness_bounds::inverse, harness_bounds::inverse}};

void answer(harness::Call& call) {
  Vec a = call.vector(), b = call.vector();
  const double shortest = call.number(), longest = call.number(), inverse_a = call.number();
  wanted(a, b, shortest, longest, inverse_a, call.number());
  call.answer(a);
  call.answer(b);
}

#endif
