// SPDX-License-Identifier: MIT-0
#pragma once

const harness::Wanted<double(double theta, double ch)> wanted_brake = left_of_brake;
const harness::Wanted<double(double theta, double homega)> wanted_swing = left_of_swing;
const harness::Wanted<double(double theta, double omega, double zeta)> wanted_longest =
    longest_step;
const harness::Wanted<double(double ch)> wanted_least = least_theta;

void answer(harness::Call& call) {
  const double first = call.number(), second = call.number(), third = call.number();
  if (call.function() == 0) call.answer(wanted_brake(first, second));
  if (call.function() == 1) call.answer(wanted_swing(first, second));
  if (call.function() == 2) call.answer(wanted_longest(first, second, third));
  if (call.function() == 3) call.answer(wanted_least(first));
}
