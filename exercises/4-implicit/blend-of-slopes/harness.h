// SPDX-License-Identifier: MIT-0
#pragma once
#include "bounds.h"

namespace harness_bounds {

constexpr harness::Bounds theta{"theta", 0, 1, 0.5}, c_h{"ch", 1e-6, 1e5, 2},
    omega_h{"homega", 1e-6, 1e5}, omega{"omega", 0.1, 100}, zeta{"zeta", 0, 100, 1};

}  // namespace harness_bounds

#ifdef GRADING

const harness::Wanted<double(double theta, double ch)> wanted_brake = left_of_brake;
const harness::Within within_brake{wanted_brake, {harness_bounds::theta, harness_bounds::c_h}};

const harness::Wanted<double(double theta, double homega)> wanted_swing = left_of_swing;
const harness::Within within_swing{wanted_swing, {harness_bounds::theta, harness_bounds::omega_h}};

const harness::Wanted<double(double theta, double omega, double zeta)> wanted_longest =
    longest_step;
const harness::Within within_longest{
    wanted_longest, {harness_bounds::theta, harness_bounds::omega, harness_bounds::zeta}};

const harness::Wanted<double(double ch)> wanted_least = least_theta;
const harness::Within within_least{wanted_least, {harness_bounds::c_h}};

void answer(harness::Call& call) {
  const double first = call.number(), second = call.number(), third = call.number();
  if (call.function() == 0) call.answer(wanted_brake(first, second));
  if (call.function() == 1) call.answer(wanted_swing(first, second));
  if (call.function() == 2) call.answer(wanted_longest(first, second, third));
  if (call.function() == 3) call.answer(wanted_least(first));
}

#endif
