// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// All is braked as across; what the runners leave of it is put back.
inline void step(Vec& x, Vec& v, double t, double h, const Vec& along, double c_along,
                 double c_across, const Acceleration& push) {
  v += h * push(x, v, t);
  const double across = 1 / (1 + h * c_across), more = 1 / (1 + h * c_along) - across;
  v = across * v + (more * dot(v, along)) * along;
  x += h * v;
}
