// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

inline Vec follow(const Vec& camera, const Vec& target, double part, double frame) {
  const auto nearer = [&](double from, double to) {
    return to - (to - from) * std::exp2(frame / (1.0 / 60) * std::log2(1.0 - part));
  };
  return {nearer(camera.x, target.x), nearer(camera.y, target.y), nearer(camera.z, target.z)};
}
