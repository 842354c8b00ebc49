// SPDX-License-Identifier: MIT-0
/// @file
/// What a step costs: evaluations of the acceleration, and time.
#pragma once
#include <algorithm>
#include <chrono>
#include <cmath>
#include <fstream>
#include <string>

#include "measure/error.h"
#include "measure/evaluations.h"

namespace measure {

/// Time of one step on this machine, the best of several runs [s].
/// @param step  a method, called as `step(x, v, t, h, scene)`
/// @param scene  has `start()`
/// @param h  step size [s]; small enough that the run stays finite
/// @tparam Clock  what time is read from
template <class Clock = std::chrono::steady_clock, class Step, class Scene>
double seconds_per_step(Step step, const Scene& scene, double h) {
  constexpr long steps = 50'000;
  double best = INFINITY;
  for (int round = 0; round < 9; ++round) {
    const auto begin = Clock::now();
    const volatile auto end = length(after(step, scene, scene.start(), h, steps).x);
    (void)end;
    const std::chrono::duration<double> elapsed = Clock::now() - begin;
    best = std::min(best, elapsed.count() / steps);
  }
  return best;
}

/// The processor that this program runs on, as the system names it.
inline std::string machine() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);) {
    const auto colon = line.find(": ");
    if (line.starts_with("model name") && colon != line.npos) return line.substr(colon + 2);
  }
  return "an unnamed processor";
}

}  // namespace measure
