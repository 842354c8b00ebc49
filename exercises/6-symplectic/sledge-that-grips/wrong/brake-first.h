// fails: pulled at a rope it ends at one speed, however long the step
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// The division before the push, as Box2D 3 and Avian do it for one drag.
inline void step(Vec& x, Vec& v, double t, double h, const Vec& along, double c_along,
                 double c_across, const Acceleration& push) {
  const Vec glide = dot(v, along) * along;
  v = glide / (1 + c_along * h) + (v - glide) / (1 + c_across * h);
  v += h * push(x, v, t);
  x += h * v;
}
