// SPDX-License-Identifier: MIT-0
#pragma once

const harness::Wanted<double(int links, double frame, const Plan& how)> wanted_stretch = stretch;
const harness::Wanted<Plan(int links, double frame, double most, double move, double pull)> wanted =
    plan;

void answer(harness::Call& call) {
  const int links = call.whole_number();
  const double frame = call.number();
  if (call.function() == 0) {
    const int substeps = call.whole_number();
    return call.answer(wanted_stretch(links, frame, {substeps, call.whole_number()}));
  }
  const double most = call.number(), move = call.number();
  const Plan best = wanted(links, frame, most, move, call.number());
  call.answer(best.substeps);
  call.answer(best.iterations);
}
