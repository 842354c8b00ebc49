// SPDX-License-Identifier: MIT-0
/// @file
/// Takes a number of equal steps and lets somebody watch.
#pragma once
#include "integrate/constant_acceleration.h"
#include "integrate/euler.h"
#include "integrate/symplectic_euler.h"
#include "scenes/state.h"

/// What is asked of a method on a scene: errors, orders, energies, limits and costs.
namespace measure {

/// integrate::euler as an object that can be handed to run() and to the other measurements.
inline constexpr auto euler = [](auto& x, auto& v, auto t, auto h, auto&& acceleration) {
  integrate::euler(x, v, t, h, acceleration);
};

/// integrate::constant_acceleration as an object that can be handed on.
inline constexpr auto constant_acceleration = [](auto& x, auto& v, auto t, auto h,
                                                 auto&& acceleration) {
  integrate::constant_acceleration(x, v, t, h, acceleration);
};

/// integrate::symplectic_euler as an object that can be handed on.
inline constexpr auto symplectic_euler = [](auto& x, auto& v, auto t, auto h, auto&& acceleration) {
  integrate::symplectic_euler(x, v, t, h, acceleration);
};

// [run]
/// Takes `steps` equal steps; `observe` sees the start and the state after each step.
///
/// The time is `n * h` and never a sum of steps, so that it is right to rounding however long the
/// run is.
///
/// @param step  a method, called as `step(x, v, t, h, scene)`
/// @param scene  the acceleration, called as `scene(x, v, t)`
/// @param s  the start; holds the end afterwards
/// @param h  step size [s]
/// @param steps  how many steps
/// @param observe  called as `observe(t, s)`, `steps + 1` times
template <class Step, class Scene, class Vec, class Real, class Observe>
void run(Step step, const Scene& scene, scenes::State<Vec>& s, Real h, long steps,
         Observe&& observe) {
  observe(Real(0), s);
  for (long n = 0; n < steps; ++n) {
    step(s.x, s.v, Real(n) * h, h, scene);
    observe(Real(n + 1) * h, s);
  }
}
// [run]

/// The state after `steps` equal steps.
///
/// @param step  a method, called as `step(x, v, t, h, scene)`
/// @param scene  the acceleration, called as `scene(x, v, t)`
/// @param s  the start
/// @param h  step size [s]
/// @param steps  how many steps
template <class Step, class Scene, class Vec, class Real>
scenes::State<Vec> after(Step step, const Scene& scene, scenes::State<Vec> s, Real h, long steps) {
  run(step, scene, s, h, steps, [](Real, const scenes::State<Vec>&) {});
  return s;
}

}  // namespace measure
