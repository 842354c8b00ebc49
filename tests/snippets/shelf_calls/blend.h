// SPDX-License-Identifier: MIT-0
#pragma once
#include "numbers.h"

template <class Kind>
void blend_on(Numbers& found) {
  using Vec = typename Kind::Vec;
  using Real = typename Kind::Real;
  const Real first[] = {1, -3, 4}, second[] = {2, Real(0.5), -9}, speed[] = {Real(0.25), 8, -1};
  const Vec before = Kind::make(first), now = Kind::make(second), v = Kind::make(speed);
  for (const Real share : {Real(0), Real(0.25), Real(0.75), Real(1)}) {
    add_all<Kind>(found, shelf::blend(before, now, share));
    add_all<Kind>(found, shelf::blend_curved(before, v, now, now, Real(1) / 16, share));
    add_all<Kind>(found, shelf::blend_turned(before, now, share, Dot<Kind>()));
  }
}
