// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// Seen by the runner, who stands still then; the ball is halfway through its change of speed at
// half time.
inline Vec throw_velocity(const Vec& from, const Vec& target, const Vec& runner, const Vec& a,
                          double time) {
  const Vec middle = 1.0 / time * (target - from) + runner;
  const double half = time / 2;
  return middle - half * a;
}
