// SPDX-License-Identifier: MIT-0
// A reference for scenes without an exact solution, by none of the book's methods: the midpoint
// rule with ever smaller steps, extrapolated to steps of no length, in long double.
#pragma once
#include <array>
#include <cstddef>

#include "scenes/state.h"

namespace reference {

using scenes::State;
using Real = long double;

template <class Vec>
State<Vec> line(const State<Vec>& from, const State<Vec>& to, Real part) {
  return {from.x + part * (to.x - from.x), from.v + part * (to.v - from.v)};
}

// Gragg's rule: leaps over two steps, smoothed at the end. Its error is a series in even powers of
// the step.
template <class Scene, class Vec>
State<Vec> leaps(const Scene& scene, const State<Vec>& s, Real t, Real length, int steps) {
  const Real h = length / Real(steps);
  State<Vec> before = s;
  State<Vec> now{s.x + h * s.v, s.v + h * scene(s.x, s.v, t)};
  for (int n = 1; n < steps; ++n) {
    const Vec a = scene(now.x, now.v, t + Real(n) * h);
    const State<Vec> next{before.x + 2 * h * now.v, before.v + 2 * h * a};
    before = now;
    now = next;
  }
  const Vec a = scene(now.x, now.v, t + length);
  const State<Vec> ahead{before.x + h * now.v, before.v + h * a};
  return line(now, ahead, Real(0.5));
}

// The state at time `end` that follows from `s` at time `begin`. Its own test says how exact.
template <class Scene, class Vec>
State<Vec> after(const Scene& scene, State<Vec> s, Real begin, Real end) {
  constexpr int parts = 48, columns = 6;
  const Real length = (end - begin) / parts;
  for (int part = 0; part < parts; ++part) {
    std::array<State<Vec>, columns> table;
    for (int row = 0; row < columns; ++row) {
      State<Vec> better = leaps(scene, s, begin + Real(part) * length, length, 2 * (row + 1));
      // Neville: from two that have the terms up to h^(2k), one that has one more.
      for (int k = 1; k <= row; ++k) {
        const Real ratio = Real(row + 1) / Real(row + 1 - k);
        const State<Vec> coarse = table[std::size_t(k - 1)];
        table[std::size_t(k - 1)] = better;
        better = line(coarse, better, ratio * ratio / (ratio * ratio - 1));
      }
      table[std::size_t(row)] = better;
    }
    s = table.back();
  }
  return s;
}

}  // namespace reference
