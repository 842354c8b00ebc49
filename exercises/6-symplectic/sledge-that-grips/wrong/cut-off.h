// fails: pulled at a rope it ends at one speed, however long the step
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// 1 - c h after the push, cut off at zero, as in PhysX and Jolt. Bodies in Godot Jolt moved at
// another speed for every tick rate until the drag was put before the push.
inline void step(Vec& x, Vec& v, double t, double h, const Vec& along, double c_along,
                 double c_across, const Acceleration& push) {
  v += h * push(x, v, t);
  const Vec glide = dot(v, along) * along;
  v = std::max(0.0, 1 - c_along * h) * glide + std::max(0.0, 1 - c_across * h) * (v - glide);
  x += h * v;
}
