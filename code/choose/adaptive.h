// SPDX-License-Identifier: MIT-0
/// @file
/// Adaptive steps in a contest: they do not end with the frames.
#pragma once
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "choose/entry.h"
#include "choose/timed_as.h"
#include "integrate/dopri5.h"
#include "measure/evaluations.h"

/// The adaptive method, as it is called; its steps do not end with the frames.
inline constexpr measure::Method adaptive{
    "Dormand-Prince, adaptive", "dopri5_adaptive", "dopri5.h", {}, {}, {}};

/// The tolerances that it is tried with, as shares of how far the motion gets.
template <class Scene>
std::vector<double> tolerances(const Scene& scene) {
  double finest = 0;
  if constexpr (requires { scene.finest_tolerance(); }) finest = scene.finest_tolerance();
  std::vector<double> all;
  for (int half_decade = 2; half_decade <= 28; ++half_decade) {
    const double tolerance = std::pow(10, -half_decade / 2.0);
    if (tolerance >= finest) all.push_back(tolerance);
  }
  return all;
}

/// A run of the adaptive method, read in frames.
struct AdaptiveRun {
  Attempt worst;
  double evaluations = 0;  ///< in a second of play
};

/// Runs the scene with adaptive steps, and reads it at the ends of frames.
template <class Scene, class Vec>
AdaptiveRun adaptive_run(const Scene& scene, const Bounds& bounds, const Truth<Vec>& truth,
                         double tolerance) {
  const measure::Counted<Scene> counted{scene};
  const auto start = scene.start();
  const auto norm = [](const Vec& error) { return measure::length(error); };
  AdaptiveRun run{.worst = {.tolerance = tolerance}};
  auto path = integrate::dopri5_path(start.x, start.v, 0.0, 1 / bounds.hz, counted);
  for (std::size_t seen = 1; seen < truth.x.size(); ++seen) {
    const double end = truth.ends[seen];
    if (!integrate::dopri5_adaptive(path, end, counted, norm, tolerance * truth.size)) {
      run.worst.error = INFINITY;
      break;
    }
    const scenes::State<Vec> now{path.position(end), path.velocity(end)};
    update_worst(run.worst, scene, now, truth.x[seen], truth.size);
  }
  run.evaluations = double(counted.evaluations) / truth.ends.back();
  return run;
}

/// The worst of the runs from all phases, in even frames or in uneven ones, and the dearest.
template <class Scene, class Frames>
AdaptiveRun adaptive_run(const Question<Scene>& question, Frames frames, double tolerance) {
  if (question.tell) question.tell("adaptive steps to " + format_number(tolerance));
  AdaptiveRun worst{.worst = {.tolerance = tolerance}};
  for (const auto& phase : question.phases) {
    const AdaptiveRun run = adaptive_run(phase.scene, question.bounds, phase.*frames, tolerance);
    if (!(run.worst.error <= worst.worst.error)) worst.worst.error = run.worst.error;
    if (!(run.worst.energy <= worst.worst.energy)) worst.worst.energy = run.worst.energy;
    worst.evaluations = std::max(worst.evaluations, run.evaluations);
  }
  return worst;
}

/// Tries every tolerance and keeps the cheapest that is good enough; if none is, the
/// nearest miss.
template <class Scene>
Entry enter_adaptive(const Question<Scene>& question) {
  const Bounds& bounds = question.bounds;
  Entry entry{.name = std::string(adaptive.name), .method = &adaptive};
  for (const double tolerance : tolerances(question.scene())) {
    const AdaptiveRun run = adaptive_run(question, &Phase<Scene>::truth, tolerance);
    const bool good = run.worst.good(bounds), first = entry.evaluations == 0;
    const bool better = good != entry.good ? good
                        : good             ? run.evaluations < entry.evaluations
                                           : nearer(run.worst, entry.last, bounds);
    if (!first && !better) continue;
    entry.last = run.worst;
    entry.good = good;
    entry.evaluations = run.evaluations;
  }
  entry.uneven = adaptive_run(question, &Phase<Scene>::uneven, entry.last.tolerance).worst.error;
  if (const char* thing = timed_as(question.scene()))
    entry.microseconds =
        entry.evaluations / 6 / bounds.hz * step_time(thing, in_a_loop, method::dopri5);
  return entry;
}
