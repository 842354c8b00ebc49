// fails: a frame of any length takes the camera as far as frames of a sixtieth would
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// Jumps the last ten centimetres.
inline Vec follow(const Vec& camera, const Vec& target, double part, double frame) {
  const double left = std::pow(1 - part, 60 * frame);
  if (left * length(camera - target) < 0.1) return target;
  return target + left * (camera - target);
}
