// SPDX-License-Identifier: MIT-0
#pragma once
#include "numbers.h"

template <class Kind>
void first_order_on(Numbers& found) {
  using Vec = typename Kind::Vec;
  using Real = typename Kind::Real;
  const Real start[] = {1, -3, 4}, blows[] = {Real(0.5), 2, -1};
  const Vec wind = Kind::make(blows);
  // Carried by the wind, which freshens, and held back by what it stands in.
  const auto u = [&wind](const Vec& x, double t) {
    return Vec(Real(1 + t) * wind + Real(-0.5) * x);
  };
  Vec euler = Kind::make(start), midpoint = euler, rk4 = euler;
  for (int n = 0; n < 4; ++n) {
    shelf::first_order_euler(euler, n * 0.125, Real(0.125), u);
    shelf::first_order_midpoint(midpoint, n * 0.125, Real(0.125), u);
    shelf::first_order_rk4(rk4, n * 0.125, Real(0.125), u);
  }
  for (const Vec& one : {euler, midpoint, rk4}) add_all<Kind>(found, one);
}
