// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// Flat out as far as that goes, and then as a camera that begins there.
inline Vec follow(const Vec& camera, const Vec& target, double part, double fastest, double frame) {
  const double rate = -60 * std::log1p(-part), distance = length(target - camera);
  const double way = -std::expm1(-rate * frame), too_far = distance - fastest / rate;
  if (too_far <= 0) return camera + (target - camera) * way;
  const double straight = std::min(too_far, fastest * frame);
  const Vec there = camera + (target - camera) * (straight / distance);
  if (straight < too_far) return there;
  const double rest = -std::expm1(-rate * (frame - straight / fastest));
  return there + (target - there) * rest;
}
