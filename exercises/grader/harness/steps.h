// SPDX-License-Identifier: MIT-0
/// @file
/// A method, run as the judge wants it.
#ifndef STEPS_H
#define STEPS_H
#include <type_traits>

#include "call.h"

namespace harness {

/// The run that the judge asks for: a force, a start, and steps.
struct Run {
  Acceleration acceleration;
  Vec x, v;
  double t = 0, h = 0;
  int steps = 0, every = 1;

  explicit Run(Call& call)
      : acceleration(call.acceleration()),
        x(call.vector()),
        v(call.vector()),
        t(call.number()),
        h(call.number()),
        steps(call.whole_number()),
        every(call.whole_number()) {}
};

/// Takes the steps and answers with the state after every so many of them.
/// @param step  callable `(x, v, t, h, acceleration)`, which advances x and v in place
template <class Step>
void run_steps(Call& call, Step step) {
  Run run(call);
  for (int n = 0; n < run.steps; ++n) {
    step(run.x, run.v, run.t + n * run.h, run.h, run.acceleration);
    if ((n + 1) % run.every != 0) continue;
    call.answer(run.x);
    call.answer(run.v);
  }
}

}  // namespace harness
#endif
