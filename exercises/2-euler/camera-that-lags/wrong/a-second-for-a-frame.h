// fails: a frame of any length takes the camera as far as frames of a sixtieth would
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// The part of a second, where it was the part of a frame.
inline Vec follow(const Vec& camera, const Vec& target, double part, double frame) {
  return target + std::pow(1 - part, frame) * (camera - target);
}
