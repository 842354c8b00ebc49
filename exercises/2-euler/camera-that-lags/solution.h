// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

/// Where the camera is after a frame [m].
/// @param camera  where it was [m]
/// @param target  where it wants to be [m]
/// @param part  of the way that it goes in one frame at sixty frames a second, between 0 and 1
/// @param fastest  speed that it never exceeds [m/s], above 0
/// @param frame  how long the frame took [s], 0 or more
inline Vec follow(const Vec& camera, const Vec& target, double part, double fastest, double frame) {
  const double rate = -60 * std::log1p(-part);
  const double distance = length(camera - target), near = fastest / rate;
  const double flat_out = std::clamp((distance - near) / fastest, 0.0, frame);
  const double share = flat_out > 0 ? 1 - fastest * flat_out / distance : 1;
  const double left = std::pow(1 - part, 60 * (frame - flat_out));
  return target + share * left * (camera - target);
}
