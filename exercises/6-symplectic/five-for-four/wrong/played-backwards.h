// Fails: twenty steps there and twenty back lead home
// Says: the program that went there finds the way back, and another does not: what is noted down?
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// RK4, and a tape that is played backwards.
struct Frame {
  Vec x, v, a;
};
inline std::vector<Frame> tape;

inline void step(Vec& x, Vec& v, Vec& a, double t, double h, const Acceleration& acceleration) {
  if (h < 0 && !tape.empty()) {
    x = tape.back().x;
    v = tape.back().v;
    a = tape.back().a;
    tape.pop_back();
    return;
  }
  tape.push_back({x, v, a});
  const Vec v2 = v + h / 2 * a, a2 = acceleration(x + h / 2 * v, v2, t + h / 2);
  const Vec v3 = v + h / 2 * a2, a3 = acceleration(x + h / 2 * v2, v3, t + h / 2);
  const Vec v4 = v + h * a3, a4 = acceleration(x + h * v3, v4, t + h);
  x += h / 6 * (v + 2 * v2 + 2 * v3 + v4);
  v += h / 6 * (a + 2 * a2 + 2 * a3 + a4);
  a = acceleration(x, v, t + h);
}
