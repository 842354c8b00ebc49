// SPDX-License-Identifier: MIT-0
#pragma once
#include "bounds.h"

namespace harness_bounds {

constexpr harness::Bounds h{"h", 1.0 / 60, 1.0 / 30}, c{"c", 150, 300}, velocity{"v", 0, 50};

}  // namespace harness_bounds

#ifdef GRADING

const harness::Wanted<void(Vec& x, Vec& v, double t, double h, double c,
                           const std::function<Vec(const Vec& x, double t)>& wind)>
    wanted = frame;
// A leaf drifts on from where and when the judge lets go of it.
const harness::Within within_wanted{wanted,
                                    {harness::any, harness_bounds::velocity, harness::any,
                                     harness_bounds::h, harness_bounds::c, harness::any}};

// Function 0 says c, and function 1 takes steps with that.
void answer(harness::Call& call) {
  static double c = 0;
  if (call.function() == 0) {
    c = call.number();
    return;
  }
  harness::run_steps(call, [](Vec& x, Vec& v, double t, double h, const Acceleration& air) {
    wanted(x, v, t, h, c, [&](const Vec& place, double time) { return air(place, {}, time); });
  });
}

#endif
