// SPDX-License-Identifier: MIT-0
#pragma once
#include "bounds.h"

namespace harness_bounds {

constexpr harness::Bounds duration{"duration", 0.01, 40}, tolerance{"tolerance", 1e-7, 1e-3},
    tolerance_of_pass{"tolerance", 1e-7, 1e-5};

}  // namespace harness_bounds

#ifdef GRADING

const harness::Wanted<void(Vec& x, Vec& v, double t, double duration, double tolerance,
                           const Acceleration& acceleration)>
    wanted = fly;
const harness::Within within{wanted,
                             {harness::any, harness::any, harness::any, harness_bounds::duration,
                              harness_bounds::tolerance, harness::any}};

// How long a comet's flight is hangs on its orbit.
const harness::Wanted<double(Vec x, Vec v, double t, double duration, double tolerance,
                             const Acceleration& acceleration)>
    wanted_nearest = nearest;
const harness::Within within_nearest{wanted_nearest,
                                     {harness::any, harness::any, harness::any, harness::any,
                                      harness_bounds::tolerance_of_pass, harness::any}};

constexpr int of_the_pass = 100;

// The number of the function is how many digits the tolerance has, and a hundred more where the
// pass is wanted. A step of the judge is a flight; the moment of a pass comes back as a place.
void answer(harness::Call& call) {
  const bool pass = call.function() >= of_the_pass;
  const double tolerance = std::pow(10, -(call.function() % of_the_pass));
  harness::run_steps(call,
                     [=](Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
                       if (pass)
                         x = Vec{wanted_nearest(x, v, t, h, tolerance, acceleration), 0, 0};
                       else
                         wanted(x, v, t, h, tolerance, acceleration);
                     });
}

#endif
