// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

inline double taylor(double x, double v, double a, double t) {
  return x + t * (v + t * a / 2);
}

inline Vec place_before(const Vec& x, const Vec& v, const Vec& a, double h) {
  return {taylor(x.x, v.x, a.x, -h), taylor(x.y, v.y, a.y, -h), taylor(x.z, v.z, a.z, -h)};
}

inline Vec next_place(const Vec& x, const Vec& x_previous, const Vec& a, double h) {
  Vec next = a;
  next *= std::pow(h, 2);
  next += x;
  next += x;
  next -= x_previous;
  return next;
}

inline void bounce(Vec& x, Vec& x_previous, double floor, double restitution) {
  if (x.y >= floor) return;
  const double fallen = x.y - x_previous.y;
  x.y = floor;
  x_previous.y = floor + restitution * fallen;
}
