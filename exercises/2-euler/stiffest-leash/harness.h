// SPDX-License-Identifier: MIT-0
#pragma once
#include "bounds.h"

namespace harness_bounds {

constexpr harness::Bounds k{"k", 1, 1e6}, c{"c", 0, 1e12}, m{"m", 0.01, 1e4};

}  // namespace harness_bounds

#ifdef GRADING

const harness::Wanted<double(double k, double c, double m)> wanted = longest_step;
const harness::Within within{wanted, {harness_bounds::k, harness_bounds::c, harness_bounds::m}};

void answer(harness::Call& call) {
  const double k = call.number(), c = call.number();
  call.answer(wanted(k, c, call.number()));
}

#endif
