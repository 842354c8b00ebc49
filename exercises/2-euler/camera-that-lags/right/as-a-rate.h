// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// The rate c of the drag that leaves this much after a sixtieth of a second.
inline Vec follow(const Vec& camera, const Vec& target, double part, double frame) {
  const double c = -60 * std::log(1 - part);
  return target + std::exp(-c * frame) * (camera - target);
}
