// fails: a braked spring lets go at 2 (sqrt(1 + zeta^2) + zeta), and not before
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

inline void step(Vec& x, Vec& v, double t, double h, const Vec& along, double c_along,
                 double c_across, const Acceleration& push) {
  const Vec glide = dot(v, along) * along;
  v += h * (push(x, v, t) - c_along * glide - c_across * (v - glide));
  x += h * v;
}
