// Fails: the thing ends within the wanted error, in less than three times the fewest steps
// Says: this is right for a push that never changes
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// Takes the push at the start for the whole run: its error is a h t / 2.
inline int steps_needed(const Vec& x, const Vec& v, double duration, double wanted,
                        const Acceleration& acceleration) {
  const double error = length(acceleration(x, v, 0)) * duration * duration / 2;
  return static_cast<int>(std::ceil(error / wanted));
}
