// SPDX-License-Identifier: MIT-0
#pragma once

double (*const wanted_stretch)(double re, double im) = stretch;
double (*const wanted_longest_step)(double omega, double zeta) = longest_step;

void answer(harness::Call& call) {
  const double first = call.number(), second = call.number();
  call.answer(call.function() == 0 ? wanted_stretch(first, second)
                                   : wanted_longest_step(first, second));
}
