// Fails: undone steps lead back to the start of the replay
// Says: undo asks for nothing and changes nothing: what your step has noted down is of no use here, where somebody else took the steps
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// Remembers what it did; but the button was held in another session.
inline std::vector<std::pair<Vec, Vec>> tape;

inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  tape.push_back({x, v});
  v += h * acceleration(x, v, t);
  x += h * v;
}

inline void undo(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  if (tape.empty()) return;
  x = tape.back().first;
  v = tape.back().second;
  tape.pop_back();
}
