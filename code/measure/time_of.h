// SPDX-License-Identifier: MIT-0
/// @file
/// The time of a step: of one body, of hundreds in a loop, of more than the caches hold.
#pragma once
#include <algorithm>
#include <chrono>
#include <cstddef>
#include <vector>

#include "measure/run.h"

namespace measure {

/// Bodies are taken back to the start after this many steps, so that nothing dies away to numbers
/// so small that the processor takes a slower way with them.
inline constexpr long stretch = 1000;

/// Steps in one run, of all bodies together; two of each at least.
inline constexpr long steps_timed = 20 * stretch;

/// From here on the compiler knows nothing of what a thing holds, and has to have it all in memory.
template <class Thing>
void forget(Thing& thing) {
  asm volatile("" : : "g"(&thing) : "memory");
}

/// The time of one step of one body on this machine, in one run [s], in the loop that a game would
/// write: all bodies take a step, then all take the next.
///
/// Of one body, which stays in registers, it is the latency: each step waits for the one before. Of
/// some hundreds it is the throughput: the processor overlaps their work. Of a hundred thousand it
/// is what memory leaves of that. The solver of an implicit method works in that time, too.
///
/// @param step  a method, called as `step(x, v, t, h, scene)`, or one with a memory
/// @param scene  the acceleration, called as `scene(x, v, t)`
/// @param s  the start of each body; of any type of vector, a block of many bodies among them
/// @param h  step size [s]; small enough that a thousand steps stay finite
/// @param bodies  how many
/// @tparam Clock  what time is read from
template <class Clock = std::chrono::steady_clock, class Step, class Scene, class Vec, class Real>
double time_of(Step step, const Scene& scene, const scenes::State<Vec>& s, Real h,
               std::size_t bodies = 1) {
  const std::vector first(bodies, start(step, s, h, scene));
  auto all = first;
  const auto move = [&](long rounds) __attribute__((flatten)) {
    if (bodies == 1) {
      auto body = all.front();
      for (long n = 0; n < rounds; ++n) advance(step, body, Real(n) * h, h, scene);
      all.front() = body;
    } else {
      // [loop]
      for (long n = 0; n < rounds; ++n) {
        for (auto& memory : all) advance(step, memory, Real(n) * h, h, scene);
      }
      // [loop]
    }
  };
  const long rounds = std::max(2L, steps_timed / long(bodies));
  std::chrono::duration<double> elapsed{0};
  for (long done = 0; done < rounds; done += stretch) {
    all = first;
    forget(all);
    const auto begin = Clock::now();
    move(std::min(stretch, rounds - done));
    forget(all);
    elapsed += Clock::now() - begin;
  }
  return elapsed.count() / (double(rounds) * double(bodies));
}

}  // namespace measure
