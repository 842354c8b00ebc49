// SPDX-License-Identifier: MIT-0
#pragma once

const harness::Wanted<double(double re, double im)> wanted_stretch = stretch;
const harness::Wanted<double(double omega, double zeta)> wanted_longest_step = longest_step;

void answer(harness::Call& call) {
  const double first = call.number(), second = call.number();
  call.answer(call.function() == 0 ? wanted_stretch(first, second)
                                   : wanted_longest_step(first, second));
}
