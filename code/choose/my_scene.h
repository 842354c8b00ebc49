// SPDX-License-Identifier: MIT-0
/// @file
/// A scene of one's own, as `choose --scene` takes it.
#pragma once
#include <Eigen/Core>

// [scene]
/// A lantern on a rubber band, which pulls only when it is stretched, and wind.
using Vec = Eigen::Vector2d;

inline Vec acceleration(const Vec& x, const Vec& v, double) {
  const double length = x.norm(), stretch = length - 1;
  const Vec band = stretch > 0 ? Vec(-60 * stretch / length * x) : Vec(0, 0);
  const Vec wind = Vec(2, 0) - v;
  return band + 0.3 * wind + Vec(0, -9.81);
}

inline const Vec start_x(0.5, -0.8), start_v(0, 0);
// [scene]
