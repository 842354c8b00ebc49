// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

namespace aim {

inline double along(double from, double target, double runner, double a, double time) {
  const double way = target + runner * time - from;
  return (way - a * time * time / 2.0) / time;
}

}  // namespace aim

inline Vec throw_velocity(const Vec& from, const Vec& target, const Vec& runner, const Vec& a,
                          double time) {
  Vec v;
  v.x = aim::along(from.x, target.x, runner.x, a.x, time);
  v.y = aim::along(from.y, target.y, runner.y, a.y, time);
  v.z = aim::along(from.z, target.z, runner.z, a.z, time);
  return v;
}
