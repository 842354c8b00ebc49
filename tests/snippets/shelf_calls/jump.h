// SPDX-License-Identifier: MIT-0
#pragma once
#include "numbers.h"

template <class Kind>
void jump_on(Numbers& found) {
  using Real = typename Kind::Real;
  const auto jump = shelf::jump_to(Real(4), Real(0.5));
  const Real falling = shelf::jump_to(Real(4), Real(0.25)).gravity;
  const Real released = shelf::jump_gravity(jump.speed, Real(1));
  Real x = 0, v = jump.speed;
  for (const Real frame : {Real(0.125), Real(0.03125), Real(0.1), Real(0.25)}) {
    shelf::jump_step(x, v, x < Real(2) ? jump.gravity : released, falling, frame);
    found.add(double(x));
    found.add(double(v));
  }
}
