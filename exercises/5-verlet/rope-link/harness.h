// SPDX-License-Identifier: MIT-0
#pragma once

const harness::Wanted<void(Vec& a, Vec& b, double shortest, double longest, double inverse_a,
                           double inverse_b)>
    wanted = pull;

void answer(harness::Call& call) {
  Vec a = call.vector(), b = call.vector();
  const double shortest = call.number(), longest = call.number(), inverse_a = call.number();
  wanted(a, b, shortest, longest, inverse_a, call.number());
  call.answer(a);
  call.answer(b);
}
