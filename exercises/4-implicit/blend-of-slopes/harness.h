// SPDX-License-Identifier: MIT-0
#pragma once

double (*const wanted_brake)(double theta, double ch) = left_of_brake;
double (*const wanted_swing)(double theta, double homega) = left_of_swing;
double (*const wanted_longest)(double theta, double omega, double zeta) = longest_step;
double (*const wanted_least)(double ch) = least_theta;

void answer(harness::Call& call) {
  const double first = call.number(), second = call.number(), third = call.number();
  if (call.function() == 0) call.answer(wanted_brake(first, second));
  if (call.function() == 1) call.answer(wanted_swing(first, second));
  if (call.function() == 2) call.answer(wanted_longest(first, second, third));
  if (call.function() == 3) call.answer(wanted_least(first));
}
