// SPDX-License-Identifier: MIT-0
#pragma once

const harness::Wanted<void(Vec& x, Vec& v, double t, double duration, double tolerance,
                           const Acceleration& acceleration)>
    wanted = fly;

// The number of the function is how many digits the tolerance has; a step of the judge is a flight.
void answer(harness::Call& call) {
  const double tolerance = std::pow(10, -call.function());
  harness::run_steps(call,
                     [=](Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
                       wanted(x, v, t, h, tolerance, acceleration);
                     });
}
