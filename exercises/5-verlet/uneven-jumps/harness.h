// SPDX-License-Identifier: MIT-0
#pragma once
#include "bounds.h"

namespace harness_bounds {

constexpr harness::Bounds h{"h", 0.0005, 0.5}, place{"x", 0, 200};

}  // namespace harness_bounds

#ifdef GRADING

const harness::Wanted<void(Vec& x, Vec& x_previous, double t, double h, double h_previous,
                           const Acceleration& acceleration)>
    wanted = step;
const harness::Within within_wanted{wanted,
                                    {harness_bounds::place, harness::any, harness::any,
                                     harness_bounds::h, harness_bounds::h, harness::any}};

const harness::Wanted<Vec(const Vec& x_previous, const Vec& x, const Vec& x_next, double h_previous,
                          double h)>
    wanted_velocity = velocity;
const harness::Within within_velocity{
    wanted_velocity,
    {harness::any, harness_bounds::place, harness::any, harness_bounds::h, harness_bounds::h}};

inline void tell_velocity(harness::Call& call) {
  const Vec x_previous = call.vector(), x = call.vector(), x_next = call.vector();
  const double h_previous = call.number();
  call.answer(wanted_velocity(x_previous, x, x_next, h_previous, call.number()));
}

// The frames come one by one, as in a game.
void answer(harness::Call& call) {
  if (call.function() == 1) return tell_velocity(call);
  const Acceleration acceleration = call.acceleration();
  Vec x = call.vector(), x_previous = call.vector();
  double t = call.number(), h_previous = call.number();
  for (int frames = call.whole_number(); frames > 0; --frames) {
    const double h = call.number();
    wanted(x, x_previous, t, h, h_previous, acceleration);
    call.answer(x);
    t += h;
    h_previous = h;
  }
}

#endif
