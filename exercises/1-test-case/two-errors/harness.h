// SPDX-License-Identifier: MIT-0
#pragma once

const harness::Wanted<double(double h1, double error1, double h2, double error2)> wanted_order =
    order;
const harness::Wanted<double(double wanted, double h, double error, double p)> wanted_step =
    step_for;
const harness::Wanted<int(double duration, double h, int per_step)> wanted_evaluations =
    evaluations;

void answer(harness::Call& call) {
  const double a = call.number(), b = call.number(), c = call.number();
  if (call.function() == 2) {
    return call.answer(static_cast<double>(wanted_evaluations(a, b, static_cast<int>(c))));
  }
  const double d = call.number();
  call.answer(call.function() == 0 ? wanted_order(a, b, c, d) : wanted_step(a, b, c, d));
}
