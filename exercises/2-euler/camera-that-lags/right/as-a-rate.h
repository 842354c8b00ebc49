// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// The rate c of the drag that leaves this much after a sixtieth of a second.
inline Vec follow(const Vec& camera, const Vec& target, double part, double fastest, double frame) {
  const double c = -60 * std::log(1 - part), far = length(camera - target) - fastest / c;
  if (far <= 0) return target + std::exp(-c * frame) * (camera - target);
  const double until = std::min(frame, far / fastest);
  const Vec there = camera + (fastest * until / length(target - camera)) * (target - camera);
  return until < frame ? target + std::exp(-c * (frame - until)) * (there - target) : there;
}
