// fails: a frame of any length takes the camera as far as frames of a sixtieth would
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// Takes the part that it goes for the part that is left.
inline Vec follow(const Vec& camera, const Vec& target, double part, double frame) {
  return target + std::pow(part, 60 * frame) * (camera - target);
}
