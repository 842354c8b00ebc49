// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

/// A position [m] and a velocity [m/s], or how fast they change.
struct Motion {
  Vec x, v;
};

/// Where `start` gets in a time h [s] at the rates k.
inline Motion ahead(const Motion& start, double h, const Motion& k) {
  return {start.x + h * k.x, start.v + h * k.v};
}

/// One step of Kutta's three-eighths rule.
inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  const auto slope = [&](const Motion& state, double time) {
    return Motion{state.v, acceleration(state.x, state.v, time)};
  };
  Motion s[4], k[4];
  s[0] = {x, v};
  k[0] = slope(s[0], t);
  s[1] = ahead(s[0], h / 3, k[0]);
  k[1] = slope(s[1], t + h / 3);
  s[2] = ahead(ahead(s[0], h, k[1]), -h / 3, k[0]);
  k[2] = slope(s[2], t + 2 * h / 3);
  s[3] = ahead(ahead(ahead(s[0], h, k[0]), -h, k[1]), h, k[2]);
  k[3] = slope(s[3], t + h);
  x = x + (h / 8) * (k[0].x + 3 * k[1].x + 3 * k[2].x + k[3].x);
  v = v + (h / 8) * (k[0].v + 3 * k[1].v + 3 * k[2].v + k[3].v);
}
