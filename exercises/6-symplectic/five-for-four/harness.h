// SPDX-License-Identifier: MIT-0
#pragma once
#include "bounds.h"

namespace harness_bounds {

constexpr harness::Bounds h{"h", -0.5, 0.5};

}  // namespace harness_bounds

#ifdef GRADING

const harness::Wanted<void(Vec& x, Vec& v, Vec& a, double t, double h,
                           const Acceleration& acceleration)>
    wanted = step;
const harness::Within within_wanted{
    wanted,
    {harness::any, harness::any, harness::any, harness::any, harness_bounds::h, harness::any}};

void answer(harness::Call& call) {
  Vec a;
  bool begun = false;
  harness::run_steps(call,
                     [&](Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
                       if (!begun) a = acceleration(x, v, t);
                       begun = true;
                       wanted(x, v, a, t, h, acceleration);
                     });
}

#endif
