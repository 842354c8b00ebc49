// SPDX-License-Identifier: MIT-0
/// @file
/// Takes a number of equal steps and lets somebody watch.
#pragma once
#include <array>

#include "scenes/state.h"

namespace measure {

/// The state of a method as an integrator, from one step to the next: position and velocity, if it
/// has no memory of its own.
/// @param step  a method, called as `step(x, v, t, h, scene)`, or one with a memory
/// @param s  the start, at time zero
/// @param h  step size [s]
/// @param scene  the acceleration, called as `scene(x, v, t)`
template <class Step, class Vec, class Real, class Scene>
auto start(const Step& step, const scenes::State<Vec>& s, Real h, const Scene& scene) {
  if constexpr (requires { step.start(s, h, scene); }) {
    return step.start(s, h, scene);
  } else {
    return std::array<Vec, 2>{s.x, s.v};
  }
}

/// One step of a method on its memory.
/// @param step  a method, called as `step(x, v, t, h, scene)`, or one with a memory
/// @param memory  from start(), advanced in place
/// @param t  time at the start of the step [s]
/// @param h  step size [s]
/// @param scene  the acceleration, called as `scene(x, v, t)`
template <class Step, class Memory, class Real, class Scene>
void advance(const Step& step, Memory& memory, Real t, Real h, const Scene& scene) {
  if constexpr (requires { step.step(memory, t, h, scene); }) {
    step.step(memory, t, h, scene);
  } else {
    step(memory[0], memory[1], t, h, scene);
  }
}

/// The position and velocity that the memory of a method stands for.
/// @param step  a method, called as `step(x, v, t, h, scene)`, or one with a memory
/// @param memory  from start()
/// @param t  time [s]
/// @param h  step size [s]
/// @param scene  the acceleration, called as `scene(x, v, t)`
template <class Step, class Memory, class Real, class Scene>
scenes::State<typename Memory::value_type> to_state(const Step& step, const Memory& memory, Real t,
                                                    Real h, const Scene& scene) {
  if constexpr (requires { step.to_state(memory, t, h, scene); }) {
    return step.to_state(memory, t, h, scene);
  } else {
    return {memory[0], memory[1]};
  }
}

/// Takes `steps` equal steps; `observe` sees the start and the state after each step.
///
/// The time is `n * h` and never a sum of steps, so that it is right to rounding however long the
/// run is.
///
/// @param step  a method, called as `step(x, v, t, h, scene)`, or one with a memory
/// @param scene  the acceleration, called as `scene(x, v, t)`
/// @param s  the start; holds the end afterwards
/// @param h  step size [s]
/// @param steps  how many steps
/// @param observe  called as `observe(t, s)`, `steps + 1` times
template <class Step, class Scene, class Vec, class Real, class Observe>
void run(Step step, const Scene& scene, scenes::State<Vec>& s, Real h, long steps,
         Observe&& observe) {
  auto memory = start(step, s, h, scene);
  observe(Real(0), s);
  for (long n = 0; n < steps; ++n) {
    advance(step, memory, Real(n) * h, h, scene);
    s = to_state(step, memory, Real(n + 1) * h, h, scene);
    observe(Real(n + 1) * h, s);
  }
}

/// The state after `steps` equal steps.
///
/// @param step  a method, called as `step(x, v, t, h, scene)`, or one with a memory
/// @param scene  the acceleration, called as `scene(x, v, t)`
/// @param s  the start
/// @param h  step size [s]
/// @param steps  how many steps
template <class Step, class Scene, class Vec, class Real>
scenes::State<Vec> after(Step step, const Scene& scene, const scenes::State<Vec>& s, Real h,
                         long steps) {
  auto memory = start(step, s, h, scene);
  for (long n = 0; n < steps; ++n) advance(step, memory, Real(n) * h, h, scene);
  return to_state(step, memory, Real(steps) * h, h, scene);
}

}  // namespace measure
