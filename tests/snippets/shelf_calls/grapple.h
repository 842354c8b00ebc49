// SPDX-License-Identifier: MIT-0
#pragma once
#include "numbers.h"

template <class Kind>
void grapple_on(Numbers& found) {
  using Vec = typename Kind::Vec;
  using Real = typename Kind::Real;
  const Real start[] = {1, -3, 4}, speed[] = {2, Real(0.5), -3}, pull[] = {0, 0, -10};
  const Real place[] = {-1, 2, Real(0.5)}, moves[] = {Real(0.25), 0, -1};
  Vec x = Kind::make(start), v = Kind::make(speed);
  const Vec a = Kind::make(pull), hook = Kind::make(place), hook_velocity = Kind::make(moves);
  Real length = 6;
  for (int n = 0; n < 8; ++n) {
    found.add(double(shelf::grapple_step(x, v, length, hook, hook_velocity, Real(-0.25), a,
                                         Real(1) / 16, Dot<Kind>())));
  }
  found.add(double(length));
  for (const Vec& one : {x, v}) add_all<Kind>(found, one);
}
