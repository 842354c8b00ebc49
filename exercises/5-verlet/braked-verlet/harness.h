// SPDX-License-Identifier: MIT-0
#pragma once
#include "bounds.h"

namespace harness_bounds {

constexpr harness::Bounds c{"c", 0, 100}, h{"h", 0.001, 1}, place{"x", 0, 1000}, a{"a", 0, 1000};

}  // namespace harness_bounds

#ifdef GRADING

const harness::Wanted<Vec(const Vec& x, const Vec& x_previous, const Vec& a, double c, double h)>
    wanted = next_place;
const harness::Within within_wanted{wanted,
                                    {harness_bounds::place, harness_bounds::place,
                                     harness_bounds::a, harness_bounds::c, harness_bounds::h}};

// A damped spring, whose damper is handed over apart from its force. Beyond the limit of the step
// it leaves all bounds.
inline void swing(harness::Call& call) {
  harness::Force spring = call.force();
  const double c = 2 * spring.a[1] * spring.a[0];
  spring.a[1] = 0;
  Vec x = call.vector(), v = call.vector();
  const double t = call.number(), h = call.number();
  const int steps = call.whole_number(), every = call.whole_number();
  Vec x_previous = x - h * v + h * h / 2 * (spring(x, v, t) - c * v);
  for (int n = 1; n <= steps; ++n) {
    const Vec next = next_place(x, x_previous, spring(x, {}, t), c, h);
    x_previous = x;
    x = next;
    if (n % every != 0) continue;
    call.answer(x);
    call.answer((x - x_previous) / h);
  }
}

void answer(harness::Call& call) {
  if (call.function() == 0) return swing(call);
  const Vec x = call.vector(), x_previous = call.vector(), a = call.vector();
  const double c = call.number();
  call.answer(wanted(x, x_previous, a, c, call.number()));
}

#endif
