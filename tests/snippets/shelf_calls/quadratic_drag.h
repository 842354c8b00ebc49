// SPDX-License-Identifier: MIT-0
#pragma once
#include "numbers.h"

template <class Kind>
void quadratic_drag_on(Numbers& found) {
  using Vec = typename Kind::Vec;
  using Real = typename Kind::Real;
  const Real place[] = {1, -3, 4}, speed[] = {20, Real(0.5), -9}, down[] = {0, 0, Real(-9.81)};
  const Real blows[] = {Real(0.25), 0, -1};
  const Vec gravity = Kind::make(down), wind = Kind::make(blows);
  Vec x = Kind::make(place), v = Kind::make(speed);
  Real way = 0, rises = -3;
  for (int n = 0; n < 4; ++n) {
    shelf::quadratic_drag(x, v, gravity, wind, Real(0.125), Real(1) / 16, Length<Kind>());
    shelf::quadratic_drag_fall(way, rises, Real(9.81), Real(0.125), Real(1) / 8);
  }
  add_all<Kind>(found, x);
  add_all<Kind>(found, v);
  found.add(double(way));
  found.add(double(rises));
}
