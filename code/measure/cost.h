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

namespace measure {

/// A scene that counts how often it is asked for its acceleration.
template <class Scene>
struct Counted : Scene {
  mutable long evaluations = 0;  ///< how often it was asked

  /// Counts the questions to `scene`.
  explicit Counted(const Scene& scene) : Scene(scene) {}

  /// The acceleration of the scene.
  template <class Vec, class Time>
  Vec operator()(const Vec& x, const Vec& v, Time t) const {
    ++evaluations;
    return Scene::operator()(x, v, t);
  }
};

/// Evaluations of the acceleration in one step; those of the start do not count.
/// @param step  a method, called as `step(x, v, t, h, scene)`, or one with a memory
/// @param scene  has `start()`
/// @param h  step size [s]
template <class Step, class Scene>
long evaluations_per_step(Step step, const Scene& scene, double h) {
  const Counted<Scene> counted{scene};
  auto kept = start(step, scene.start(), h, counted);
  counted.evaluations = 0;
  advance(step, kept, 0.0, h, counted);
  return counted.evaluations;
}

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
