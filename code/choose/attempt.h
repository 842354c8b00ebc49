// SPDX-License-Identifier: MIT-0
/// @file
/// One run of a method on a scene, compared with the truth in every frame.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "choose/bounds.h"
#include "choose/entrants.h"
#include "choose/progress.h"
#include "choose/words.h"
#include "measure/error.h"

/// The result of one run.
struct Attempt {
  long substeps = 0;     ///< steps in each frame; 0 if they do not end with the frames
  double tolerance = 0;  ///< of an adaptive method, as a share of how far the motion gets
  double error = 0;      ///< share of how far the motion gets
  double energy = 0;     ///< relative change, where energy is kept
  bool good(const Bounds& bounds) const { return error <= bounds.error && energy <= bounds.energy; }
};

/// Returns whether the scene's energy ought to stay what it is.
template <class Scene>
bool keeps_energy(const Scene& scene) {
  if constexpr (requires { scene.energy(scene.start().x, scene.start().v); }) {
    if constexpr (requires { scene.damping(); }) return scene.damping() == 0;
    return true;
  }
  return false;
}

/// The true places of a scene at the ends of frames, and the farthest of them from the origin.
template <class Vec>
struct Truth {
  std::vector<double> ends;  ///< of the frames, and the start before them [s]
  std::vector<Vec> x;
  double size = 0;
};

/// The truth of a scene at the ends of frames.
template <class Scene>
auto truth_of(const Scene& scene, const std::vector<double>& ends) {
  Truth<std::decay_t<decltype(scene.start().x)>> truth{ends, {}, 0};
  for (const double end : ends) {
    truth.x.push_back(scene.exact(end).x);
    truth.size = std::max(truth.size, measure::length(truth.x.back()));
  }
  return truth;
}

/// The farthest from the origin that the motion gets.
template <class Scene>
double size_of(const Scene& scene, const Bounds& bounds) {
  return truth_of(scene, even_frames(bounds)).size;
}

/// A scene whose run begins somewhere within a frame, and what is true of it then.
template <class Scene>
struct Phase {
  using Vec = std::decay_t<decltype(std::declval<const Scene&>().start().x)>;
  Scene scene;
  Truth<Vec> truth;     ///< at the ends of even frames
  Truth<Vec> uneven{};  ///< at the ends of uneven ones
};

/// What is asked of all methods alike.
template <class Scene>
struct Question {
  Bounds bounds;
  std::vector<Phase<Scene>> phases;  ///< at least one; the worst counts
  Tell tell{};                       ///< how far the search has got

  const Scene& scene() const { return phases.front().scene; }
};

/// The error or the change of the energy over its bound, the larger of the two: one or less is
/// good.
inline double miss(const Attempt& attempt, const Bounds& bounds) {
  const double worst = std::max(attempt.error / bounds.error, attempt.energy / bounds.energy);
  return worst < INFINITY ? worst : INFINITY;
}

/// Returns whether one attempt is nearer to good enough than the other.
inline bool nearer(const Attempt& one, const Attempt& other, const Bounds& bounds) {
  return miss(one, bounds) < miss(other, bounds);
}

/// Compares the state at the end of a frame with the truth, and keeps the worst: the error as a
/// share of `size`, which is how far the motion gets, and the change of the energy.
template <class Scene, class Vec>
void update_worst(Attempt& worst, const Scene& scene, const scenes::State<Vec>& now,
                  const Vec& truth, double size) {
  const double error = measure::length(now.x - truth) / size;
  if (!(error <= worst.error)) worst.error = error;
  if constexpr (requires { scene.energy(now.x, now.v); }) {
    if (!keeps_energy(scene)) return;
    const auto start = scene.start();
    const double first = scene.energy(start.x, start.v);
    const double change = std::abs(scene.energy(now.x, now.v) / first - 1);
    if (!(change <= worst.energy)) worst.energy = change;
  }
}

/// Runs the scene from one phase, and compares it with the truth in every frame, which is when a
/// player sees it. Gives up as soon as it misses the bounds by more than `patience`.
template <class Scene>
Attempt attempt(const measure::Method& method, const Phase<Scene>& phase, const Bounds& bounds,
                long substeps, double patience) {
  const auto& [scene, truth, uneven] = phase;
  Attempt worst{.substeps = substeps};
  const double h = 1 / (bounds.hz * double(substeps));
  auto memory = measure::start(method, scene.start(), h, scene);
  long n = 0;  // steps taken
  for (std::size_t seen = 1; seen < truth.x.size(); ++seen) {
    try {
      for (; n < long(seen) * substeps; ++n)
        measure::advance(method, memory, double(n) * h, h, scene);
    } catch (const std::runtime_error&) {
      worst.error = INFINITY;  // an implicit step that could not be solved
      break;
    }
    update_worst(worst, scene, measure::to_state(method, memory, double(n) * h, h, scene),
                 truth.x[seen], truth.size);
    if (miss(worst, bounds) > patience) break;
  }
  return worst;
}

/// The worst of the runs from all phases.
template <class Scene>
Attempt attempt(const measure::Method& method, const Question<Scene>& question, long substeps,
                double patience) {
  if (question.tell)
    question.tell(std::string(method.function) + " in " + steps(substeps) + " a frame");
  Attempt worst{.substeps = substeps};
  for (const auto& phase : question.phases) {
    const Attempt now = attempt(method, phase, question.bounds, substeps, patience);
    if (!(now.error <= worst.error)) worst.error = now.error;
    if (!(now.energy <= worst.energy)) worst.energy = now.energy;
    if (miss(worst, question.bounds) > patience) break;
  }
  return worst;
}

/// The largest error in uneven frames, each cut into as many equal steps. What is folded takes the
/// step that it was folded for, that of the mean frame.
template <class Scene>
double uneven_error(const measure::Method& method, const Phase<Scene>& phase, long substeps) {
  const auto& [scene, truth, uneven] = phase;
  Attempt worst;
  const double mean = uneven.ends.back() / double((uneven.ends.size() - 1) * std::size_t(substeps));
  auto memory = measure::start(method, scene.start(), uneven.ends[1] / double(substeps), scene);
  for (std::size_t seen = 1; seen < uneven.x.size(); ++seen) {
    const double begin = uneven.ends[seen - 1], end = uneven.ends[seen];
    const double h = (end - begin) / double(substeps);
    const double taken = &method == &method::spring_folded ? mean : h;
    try {
      for (long n = 0; n < substeps; ++n)
        measure::advance(method, memory, begin + double(n) * h, taken, scene);
    } catch (const std::runtime_error&) {
      return INFINITY;
    }
    update_worst(worst, scene, measure::to_state(method, memory, end, h, scene), uneven.x[seen],
                 uneven.size);
    if (!(worst.error < 1e3)) return INFINITY;
  }
  return worst.error;
}
