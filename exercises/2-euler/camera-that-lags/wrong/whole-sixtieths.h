// fails: uneven frames leave the camera where even ones do
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// As many frames of a sixtieth as fit, and the rest is lost.
inline Vec follow(const Vec& camera, const Vec& target, double part, double frame) {
  Vec now = camera;
  for (int n = 0; n < static_cast<int>(60 * frame); ++n) now = now + part * (target - now);
  return now;
}
