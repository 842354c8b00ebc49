// SPDX-License-Identifier: MIT-0
/// @file
/// What a step costs: evaluations of the acceleration, and time.
#pragma once
#include <chrono>
#include <cstddef>
#include <vector>

#include "measure/error.h"
#include "measure/evaluations.h"
#include "measure/run.h"

namespace measure {

/// Runs are cut into stretches of this many steps, each from the start: so nothing dies away to
/// numbers so small that the processor takes a slower way with them.
inline constexpr long stretch = 1000;

/// Time of one call, over many calls [s].
/// @param call  called as `call(one)`, where the number is 1 but the compiler can't know: what
///              depends on it can't be taken for the same again and left out. Returns a number.
/// @param calls  how many
template <class Clock, class Call>
double seconds_per_call(Call call, long calls) {
  const volatile double one = 1;
  double sum = 0;
  const auto begin = Clock::now();
  for (long n = 0; n < calls; ++n) sum += call(double(one));
  const std::chrono::duration<double> elapsed = Clock::now() - begin;
  const volatile double used = sum;
  (void)used;
  return elapsed.count() / static_cast<double>(calls);
}

/// The latency of a step on this machine, in one run [s]: one body, each step of which waits for
/// the one before.
///
/// @param step  a method, called as `step(x, v, t, h, scene)`, or one with a memory
/// @param scene  has `start()`
/// @param h  step size [s]; small enough that a thousand steps stay finite
/// @tparam Clock  what time is read from
template <class Clock = std::chrono::steady_clock, class Step, class Scene>
double seconds_per_step(Step step, const Scene& scene, double h) {
  const auto run = [&](double one) __attribute__((flatten)) {
    auto s = scene.start();
    s.x = one * s.x;
    return length(after(step, scene, s, h, stretch).x);
  };
  return seconds_per_call<Clock>(run, 50) / stretch;
}

/// The throughput of steps on this machine, in one run, as time of one step of one body [s]: many
/// bodies in a loop, so that the processor overlaps their work.
///
/// @param step  a method, called as `step(x, v, t, h, scene)`, or one with a memory
/// @param scene  has `start()`
/// @param h  step size [s]; small enough that a thousand steps stay finite
/// @param bodies  how many
/// @tparam Clock  what time is read from
template <class Clock = std::chrono::steady_clock, class Step, class Scene>
double seconds_per_step_of_many(Step step, const Scene& scene, double h, std::size_t bodies) {
  const auto run = [&](double one) __attribute__((flatten)) {
    auto s = scene.start();
    s.x = one * s.x;
    std::vector all(bodies, start(step, s, h, scene));
    for (long n = 0; n < stretch; ++n) {
      for (auto& kept : all) advance(step, kept, double(n) * h, h, scene);
    }
    double sum = 0;
    for (auto& kept : all) sum += length(state_of(step, kept, double(stretch) * h, h, scene).x);
    return sum;
  };
  return seconds_per_call<Clock>(run, 1) / static_cast<double>(stretch * static_cast<long>(bodies));
}

}  // namespace measure
