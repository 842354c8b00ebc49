// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

/// One step of symplectic Euler for a sledge, with drag divided.
inline void step(Vec& x, Vec& v, double t, double h, const Vec& along, double c_along,
                 double c_across, const Acceleration& push) {
  v = v + h * push(x, v, t);
  const Vec glide = dot(v, along) * along;
  const Vec slip = v - glide;
  v = glide / (1 + c_along * h) + slip / (1 + c_across * h);
  x = x + h * v;
}
