// SPDX-License-Identifier: MIT-0
#pragma once
#include "bounds.h"

namespace harness_bounds {

constexpr harness::Bounds turns{"turns", 1, 2};  // of an orbit, in a flight

}  // namespace harness_bounds

#ifdef GRADING

const harness::Wanted<void(Vec& x, Vec& v, double t, double seconds,
                           const Acceleration& acceleration)>
    wanted = fly;
const harness::Within within{
    wanted, {harness::any, harness::any, harness::any, harness::any, harness::any}};

// One step of the judge's is a whole flight.
void answer(harness::Call& call) {
  harness::run_steps(call, wanted);
}

#endif
