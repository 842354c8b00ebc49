// fails: pulled at a rope it ends at one speed, however long the step
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// Braked across and then along: what glides is braked twice.
inline void step(Vec& x, Vec& v, double t, double h, const Vec& along, double c_along,
                 double c_across, const Acceleration& push) {
  v += h * push(x, v, t);
  v = v / (1 + c_across * h);
  const Vec glide = dot(v, along) * along;
  v = v - glide + glide / (1 + c_along * h);
  x += h * v;
}
