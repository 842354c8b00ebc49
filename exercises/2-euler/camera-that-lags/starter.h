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
  const Vec step = part * 60 * frame * (target - camera);
  const double most = fastest * frame;
  return camera + (length(step) > most ? most / length(step) : 1) * step;
}
