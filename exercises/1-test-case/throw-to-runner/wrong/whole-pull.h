// fails: a ball lands on a target that stands still
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// Takes off what the pull does to the velocity; to the place it does half of that.
inline Vec throw_velocity(const Vec& from, const Vec& target, const Vec& runner, const Vec& a,
                          double time) {
  return (target - from) / time + runner - time * a;
}
