// SPDX-License-Identifier: MIT-0
#pragma once
#include "numbers.h"

template <class Kind>
void fixed_step_on(Numbers& found) {
  using Real = typename Kind::Real;
  shelf::FixedStep<Real> clock{Real(1) / 64};
  const auto spend = [&](double length) {
    double last = 0;
    clock.frame(length, [&](double t) { last = t; });
    found.add(last);
    found.add(double(clock.blend()));
    found.add(double(clock.steps));
    found.add(clock.time());
  };
  for (const double length : {0.25, 0.03125, -1.0, 100.0}) spend(length);
  clock.change_step(Real(1) / 48);
  for (const double length : {0.015625, 0.125}) spend(length);
  clock.steps = 5'000'000'000;  // more than 32 bits hold
  spend(0.25);
}
