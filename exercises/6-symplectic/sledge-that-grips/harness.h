// SPDX-License-Identifier: MIT-0
#pragma once
#include "bounds.h"

namespace harness_bounds {

constexpr harness::Bounds h{"h", 0.001, 2000}, along{"along", 1, 1}, drag{"drag", 0, 150};

}  // namespace harness_bounds

#ifdef GRADING

const harness::Wanted<void(Vec& x, Vec& v, double t, double h, const Vec& along, double c_along,
                           double c_across, const Acceleration& push)>
    wanted = step;
const harness::Within within_wanted{
    wanted,
    {harness::any, harness::any, harness::any, harness_bounds::h, harness_bounds::along,
     harness_bounds::drag, harness_bounds::drag, harness::any}};

// A sledge, and how it is to be run; or a run on a spring, whose damping is given as drag.
void answer(harness::Call& call) {
  Vec along{2.0 / 3, 1.0 / 3, 2.0 / 3};
  double c_along = 0, c_across = 0;
  if (call.function() == 0) {
    along = call.vector();
    c_along = call.number();
    c_across = call.number();
  }
  harness::Force force = call.force();
  if (call.function() == 1) {
    c_along = c_across = 2 * force.a[1] * force.a[0];
    force.a[1] = 0;
  }
  Vec x = call.vector(), v = call.vector();
  const double t = call.number(), h = call.number();
  const int steps = call.whole_number(), every = call.whole_number();
  for (int n = 0; n < steps; ++n) {
    wanted(x, v, t + n * h, h, along, c_along, c_across, force);
    if ((n + 1) % every != 0) continue;
    call.answer(x);
    call.answer(v);
  }
}

#endif
