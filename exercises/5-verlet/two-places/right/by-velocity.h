// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// Leapfrog in disguise: the last distance over its time is the velocity half a step ago.
inline Vec next_place(const Vec& x, const Vec& x_previous, const Vec& a, double h) {
  const Vec v_half_ago = (x - x_previous) / h;
  const Vec v_half_ahead = v_half_ago + h * a;
  return x + h * v_half_ahead;
}

inline Vec place_before(const Vec& x, const Vec& v, const Vec& a, double h) {
  const Vec v_half_ago = v - h / 2 * a;
  return x - h * v_half_ago;
}

// The distance of the last step, mirrored, and laid out again from where the spark is now.
inline void bounce(Vec& x, Vec& x_previous, double floor, double restitution) {
  if (!(x.y < floor)) return;
  Vec distance = x - x_previous;
  distance.y *= -restitution;
  x = Vec{x.x, floor, x.z};
  x_previous = x - distance;
}
