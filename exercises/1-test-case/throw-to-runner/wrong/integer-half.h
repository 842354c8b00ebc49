// fails: a ball lands on a target that stands still
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// 1/2 is 0 in whole numbers.
inline Vec throw_velocity(const Vec& from, const Vec& target, const Vec& runner, const Vec& a,
                          double time) {
  return (target - from) / time + runner - (1 / 2) * time * a;
}
