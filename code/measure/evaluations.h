// SPDX-License-Identifier: MIT-0
/// @file
/// How often a step asks for the acceleration.
#pragma once
#include "measure/run.h"

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
  auto memory = start(step, scene.start(), h, counted);
  counted.evaluations = 0;
  advance(step, memory, 0.0, h, counted);
  return counted.evaluations;
}

}  // namespace measure
