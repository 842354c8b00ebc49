// fails: a ball and a runner come to one place
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// Aims at where the runner is now.
inline Vec throw_velocity(const Vec& from, const Vec& target, const Vec& runner, const Vec& a,
                          double time) {
  return (target - from) / time - 0.5 * time * a;
}
