// SPDX-License-Identifier: MIT-0
#pragma once

double (*const wanted_order)(double h1, double error1, double h2, double error2) = order;
double (*const wanted_step)(double wanted, double h, double error, double p) = step_for;
int (*const wanted_evaluations)(double duration, double h, int per_step) = evaluations;

void answer(harness::Call& call) {
  const double a = call.number(), b = call.number(), c = call.number();
  if (call.function() == 2) {
    return call.answer(static_cast<double>(wanted_evaluations(a, b, static_cast<int>(c))));
  }
  const double d = call.number();
  call.answer(call.function() == 0 ? wanted_order(a, b, c, d) : wanted_step(a, b, c, d));
}
