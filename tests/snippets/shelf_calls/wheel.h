// SPDX-License-Identifier: MIT-0
#pragma once
#include "numbers.h"

template <class Kind>
void wheel_on(Numbers& found) {
  using Vec = typename Kind::Vec;
  using Real = typename Kind::Real;
  const Real start[] = {1, -3, 4}, upwards[] = {0, 1, 0};
  const Vec up = Kind::make(upwards);
  Vec v = Kind::make(start);
  Real force = 0, grip = 0;
  const shelf::Suspension<Real> suspension{Real(3000), Real(250)};
  for (int n = 0; n < 4; ++n) {
    const Real h = Real(1) / Real(16 + n), rises = Kind::read(v, 1);
    v = v + h * force * Real(0.01) * up;
    v = v +
        Real(0.01) * shelf::wheel_push(force, Real(0.125), rises, Real(0.01), suspension, h) * up;
    found.add(double(force));
    found.add(double(shelf::wheel_grip(grip, Kind::read(v, 0), Real(0.02), Real(50), h)));
  }
  add_all<Kind>(found, v);
}
