// fails: a ball lands on a target that stands still
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// The pull is added where it should be taken off.
inline Vec throw_velocity(const Vec& from, const Vec& target, const Vec& runner, const Vec& a,
                          double time) {
  return (target - from) / time + runner + 0.5 * time * a;
}
