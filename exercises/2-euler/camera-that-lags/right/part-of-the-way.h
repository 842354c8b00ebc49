// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

inline Vec follow(const Vec& camera, const Vec& target, double part, double frame) {
  const double way = -std::expm1(60 * frame * std::log1p(-part));
  return camera + (target - camera) * way;
}
