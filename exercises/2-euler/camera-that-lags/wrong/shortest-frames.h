// fails: after a hitch the camera is near its target and not beyond it
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// A frame can be no longer than a tenth of a second: then a hitch is one.
inline Vec follow(const Vec& camera, const Vec& target, double part, double frame) {
  const double left = std::pow(1 - part, 60 * std::min(frame, 0.1));
  return target + left * (camera - target);
}
