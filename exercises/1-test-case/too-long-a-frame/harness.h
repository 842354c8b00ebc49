// SPDX-License-Identifier: MIT-0
#pragma once

const harness::Wanted<int(double& saved, double length, double h, int most)> wanted_steps =
    steps_due;
const harness::Wanted<double(double draw, double cost, double h, int most)> wanted_frame =
    settled_frame;

void answer(harness::Call& call) {
  double first = call.number();
  const double second = call.number(), h = call.number();
  const int most = call.whole_number();
  if (call.function() == 1) return call.answer(wanted_frame(first, second, h, most));
  call.answer(static_cast<double>(wanted_steps(first, second, h, most)));
  call.answer(first);
}
