// SPDX-License-Identifier: MIT-0
#pragma once

const harness::Wanted<double(double k, double c, double m)> wanted = longest_step;

void answer(harness::Call& call) {
  const double k = call.number(), c = call.number();
  call.answer(wanted(k, c, call.number()));
}
