// SPDX-License-Identifier: MIT-0
#pragma once
#include "bounds.h"

namespace harness_bounds {

constexpr harness::Bounds links{"links", 20, 40}, frame{"frame", 1.0 / 144, 1.0 / 24},
    most{"most", 0.01, 1}, move{"move", 0.01, 3.6}, pull{"pull", 0.1, 0.3};

}  // namespace harness_bounds

#ifdef GRADING

const harness::Wanted<double(int links, double frame, const Plan& how)> wanted_stretch = stretch;
const harness::Within within_stretch{wanted_stretch,
                                     {harness_bounds::links, harness_bounds::frame, harness::any}};

const harness::Wanted<Plan(int links, double frame, double most, double move, double pull)> wanted =
    plan;
const harness::Within within_wanted{
    wanted,
    {harness_bounds::links, harness_bounds::frame, harness_bounds::most, harness_bounds::move,
     harness_bounds::pull}};

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

#endif
