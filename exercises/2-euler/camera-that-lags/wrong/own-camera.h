// fails: a target that jumps is followed from where the camera is
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// Keeps the distance itself, and does not see that the target jumped.
inline Vec follow(const Vec& camera, const Vec& target, double part, double frame) {
  static Vec distance = camera - target;
  distance = std::pow(1 - part, 60 * frame) * distance;
  return target + distance;
}
