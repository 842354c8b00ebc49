// fails: pulled at a rope it ends at one speed, however long the step
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// Exact for drag alone, and not for drag and a pull.
inline void step(Vec& x, Vec& v, double t, double h, const Vec& along, double c_along,
                 double c_across, const Acceleration& push) {
  v += h * push(x, v, t);
  const Vec glide = dot(v, along) * along;
  v = std::exp(-c_along * h) * glide + std::exp(-c_across * h) * (v - glide);
  x += h * v;
}
