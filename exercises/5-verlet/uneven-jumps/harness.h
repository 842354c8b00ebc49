// SPDX-License-Identifier: MIT-0
#pragma once

const harness::Wanted<void(Vec& x, Vec& x_previous, double t, double h, double h_previous,
                           const Acceleration& acceleration)>
    wanted = step;

// The frames come one by one, as in a game.
void answer(harness::Call& call) {
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
