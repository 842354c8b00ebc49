// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// Along the way there is one number, the distance.
inline double distance_after(double distance, double part, double fastest, double frame) {
  const double sixtieths = std::log2(1.0 - part);
  const double border = fastest / (-60 * sixtieths * std::log(2.0));
  if (distance > border + fastest * frame) return distance - fastest * frame;
  const double flat_out = std::max(0.0, (distance - border) / fastest);
  return std::min(distance, border) * std::exp2((frame - flat_out) / (1.0 / 60) * sixtieths);
}

inline Vec follow(const Vec& camera, const Vec& target, double part, double fastest, double frame) {
  const double before = length(camera - target);
  if (before == 0) return target;
  const double after = distance_after(before, part, fastest, frame) / before;
  const auto nearer = [&](double from, double to) { return to + after * (from - to); };
  return {nearer(camera.x, target.x), nearer(camera.y, target.y), nearer(camera.z, target.z)};
}
