// fails: an orbit loses only the energy that RK4 takes
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

struct Motion {
  Vec x, v;
};

inline Motion ahead(const Motion& start, double h, const Motion& k) {
  return {start.x + h * k.x, start.v + h * k.v};
}

// Another state, found along the slope that the second used, too.
inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  const auto slope = [&](const Motion& state, double time) {
    return Motion{state.v, acceleration(state.x, state.v, time)};
  };
  Motion s[4], k[4];
  s[0] = {x, v};
  k[0] = slope(s[0], t);
  s[1] = ahead(s[0], h / 2, k[0]);
  k[1] = slope(s[1], t + h / 2);
  s[2] = ahead(s[0], h / 2, k[0]);
  k[2] = slope(s[2], t + h / 2);
  s[3] = ahead(s[0], h, k[2]);
  k[3] = slope(s[3], t + h);
  x = x + (h / 6) * (k[0].x + 2 * k[1].x + 2 * k[2].x + k[3].x);
  v = v + (h / 6) * (k[0].v + 2 * k[1].v + 2 * k[2].v + k[3].v);
}
