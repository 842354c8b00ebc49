// SPDX-License-Identifier: MIT-0
#pragma once
#include "numbers.h"

template <class Kind>
void fixed_step_on(Numbers& found) {
  using Real = typename Kind::Real;
  shelf::FixedStep<Real> clock{Real(1) / 64};
  for (const Real frame : {Real(0.25), Real(0.03125), Real(-1), Real(100)}) {
    Real last = 0;
    clock.frame(frame, [&](Real t) { last = t; });
    found.add(double(last));
    found.add(double(clock.blend()));
    found.add(double(clock.steps));
  }
}
