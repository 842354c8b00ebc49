// SPDX-License-Identifier: MIT-0
#pragma once

double (*const wanted_stretch)(int links, double frame, const Plan& how) = stretch;
Plan (*const wanted)(int links, double frame, double most, double move, double pull) = plan;

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
