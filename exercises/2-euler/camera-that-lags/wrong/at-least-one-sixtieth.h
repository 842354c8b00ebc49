// fails: uneven frames leave the camera where even ones do
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// Cut into frames of a sixtieth; the last one is stretched.
inline Vec follow(const Vec& camera, const Vec& target, double part, double frame) {
  const int count = std::max(1, static_cast<int>(std::lround(60 * frame)));
  Vec now = camera;
  for (int n = 0; n < count; ++n) now = now + part * (60 * frame / count) * (target - now);
  return now;
}
