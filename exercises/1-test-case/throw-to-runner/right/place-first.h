// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// Where both will be, and what the pull alone does to the ball until then.
inline Vec throw_velocity(const Vec& from, const Vec& target, const Vec& runner, const Vec& a,
                          double time) {
  const Vec meeting = target + time * runner;
  const Vec pulled = from + (time * time / 2) * a;
  return (meeting - pulled) / time;
}
