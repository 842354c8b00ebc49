// SPDX-License-Identifier: MIT-0
#pragma once
#include "numbers.h"

template <class Kind>
void damper_on(Numbers& found) {
  using Real = typename Kind::Real;
  using Vec = typename Kind::Vec;
  const Real first[] = {1, -3, 4}, second[] = {2, Real(0.5), Real(0.25)},
             line[] = {Real(0.6), 0, Real(0.8)};
  Vec v1 = Kind::make(first), v2 = Kind::make(second);
  const Vec along = Kind::make(line);
  for (const Real c : {Real(0), Real(8), Real(1000)}) {
    shelf::damper_along(v1, v2, Real(0.125), c, Real(1), Real(0.25), along, Dot<Kind>());
    add_all<Kind>(found, v1);
    add_all<Kind>(found, v2);
    shelf::damper(v1, v2, Real(0.125), c / 4, Real(0.5), Real(0));
    add_all<Kind>(found, v1);
    add_all<Kind>(found, v2);
  }
}
