// SPDX-License-Identifier: MIT-0
#pragma once
#include "bounds.h"

namespace harness_bounds {

constexpr harness::Bounds u{"u", -10, 10, 0}, omega{"omega", 0.5, 100}, h{"h", 1e-7, 1e9};

}  // namespace harness_bounds

#ifdef GRADING

const harness::Wanted<void(double& x, double& v, double target, double u, double omega, double h)>
    wanted = settle;
const harness::Within within_wanted{wanted,
                                    {harness::any, harness::any, harness::any, harness_bounds::u,
                                     harness_bounds::omega, harness_bounds::h}};

// Start, frequency, how many frames, and each frame's target, its velocity and its length; answers
// after each.
void answer(harness::Call& call) {
  double x = call.number(), v = call.number();
  const double omega = call.number();
  const int frames = call.whole_number();
  for (int n = 0; n < frames; ++n) {
    const double target = call.number(), u = call.number(), h = call.number();
    wanted(x, v, target, u, omega, h);
    call.answer(x);
    call.answer(v);
  }
}

#endif
