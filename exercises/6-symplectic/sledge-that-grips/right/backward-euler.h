// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// The new velocity's drag, solved for: v_new = v + h a - h c v_new.
inline double solved(double pushed, double h, double c) {
  return pushed / (1.0 + h * c);
}

inline void step(Vec& x, Vec& v, double t, double h, const Vec& along, double c_along,
                 double c_across, const Acceleration& push) {
  const Vec a = push(x, v, t);
  const Vec pushed = {v.x + h * a.x, v.y + h * a.y, v.z + h * a.z};
  const double speed = pushed.x * along.x + pushed.y * along.y + pushed.z * along.z;
  const Vec slip = pushed - speed * along;
  const double glide = solved(speed, h, c_along);
  v = {solved(slip.x, h, c_across) + glide * along.x, solved(slip.y, h, c_across) + glide * along.y,
       solved(slip.z, h, c_across) + glide * along.z};
  x = x + v * h;
}
