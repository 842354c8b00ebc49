// SPDX-License-Identifier: MIT-0
#pragma once
#include "bounds.h"

namespace harness_bounds {

constexpr harness::Bounds re{"re", -10, 0}, im{"im", -10, 10, 0}, omega{"omega", 0.1, 1000},
    zeta{"zeta", 0, 10, 1};

}  // namespace harness_bounds

#ifdef GRADING

const harness::Wanted<double(double re, double im)> wanted_stretch = stretch;
const harness::Within within_stretch{wanted_stretch, {harness_bounds::re, harness_bounds::im}};

const harness::Wanted<double(double omega, double zeta)> wanted_longest_step = longest_step;
const harness::Within within_longest_step{wanted_longest_step,
                                          {harness_bounds::omega, harness_bounds::zeta}};

void answer(harness::Call& call) {
  const double first = call.number(), second = call.number();
  call.answer(call.function() == 0 ? wanted_stretch(first, second)
                                   : wanted_longest_step(first, second));
}

#endif
