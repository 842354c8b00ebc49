// SPDX-License-Identifier: MIT-0
#pragma once
#include "bounds.h"

namespace harness_bounds {

constexpr harness::Bounds duration{"duration", 0.01, 40}, tolerance{"tolerance", 1e-7, 1e-3},
    tolerance_of_pass{"tolerance", 1e-7, 1e-5}, place{"x", 0, 250}, velocity{"v", 0, 50},
    time{"t", -10, 1000, 0};

}  // namespace harness_bounds

#ifdef GRADING

const harness::Wanted<void(Vec& x, Vec& v, double t, double duration, double tolerance,
                           const Acceleration& acceleration)>
    wanted = fly;
const harness::Within within{wanted,
                             {harness_bounds::place, harness_bounds::velocity, harness_bounds::time,
                              harness_bounds::duration, harness_bounds::tolerance, harness::any}};

// Where a comet's flight begins, and how long it is, hangs on its orbit.
const harness::Wanted<double(Vec x, Vec v, double t, double duration, double tolerance,
                             const Acceleration& acceleration)>
    wanted_nearest = nearest;
const harness::Within within_nearest{wanted_nearest,
                                     {harness::any, harness::any, harness::any, harness::any,
                                      harness_bounds::tolerance_of_pass, harness::any}};

// Function 0 says the tolerance, 1 flies, and 2 finds the pass. A step of the judge is a flight;
// the moment of a pass comes back as a place.
void answer(harness::Call& call) {
  static double tolerance = 0;
  if (call.function() == 0) {
    tolerance = call.number();
    return;
  }
  const bool pass = call.function() == 2;
  harness::run_steps(call,
                     [=](Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
                       if (pass)
                         x = Vec{wanted_nearest(x, v, t, h, tolerance, acceleration), 0, 0};
                       else
                         wanted(x, v, t, h, tolerance, acceleration);
                     });
}

#endif
