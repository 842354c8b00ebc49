// fails: a frame of any length takes the camera as far as frames of a sixtieth would
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

inline Vec follow(const Vec& camera, const Vec& target, double part, double frame) {
  const float left = std::pow(static_cast<float>(1 - part), static_cast<float>(60 * frame));
  return target + left * (camera - target);
}
