// SPDX-License-Identifier: MIT-0
/// @file
/// What the steps are wanted for.
#pragma once
#include <cmath>

#include "judge/method.h"
#include "judge/random.h"
#include "judge/waves.h"

namespace scene {

/// A thing under a force that only the judge knows, and how many steps Euler's method must take.
struct Scene {
  Acceleration acceleration;
  judge::Start start;
  double duration;
  Vec end;     // where it is without any error [m]
  int fewest;  // steps of Euler's method that end within the wanted error
  double wanted;

  double error(int steps) const {
    const judge::Path path =
        judge::run(judge::euler, start, duration / steps, steps, steps, acceleration);
    return length(path.states.back().x - end);
  }
};

/// One in which the error of a quarter of the steps is four times as large, within a hundredth, so
/// that a good guess can be made from shorter runs.
inline Scene draw(judge::Random& random, double duration) {
  for (;;) {
    const harness::Force force = random.wild();
    const judge::Waves gusts{random, 0.5, 3, 3};
    Scene scene{[=](const Vec& x, const Vec& v, double t) { return force(x, v, t) + gusts(x, t); },
                random.start(),
                duration,
                {},
                0,
                0};
    scene.start.t = 0;
    scene.end = judge::truth(scene.start, scene.duration / 512, 512, 512, scene.acceleration)
                    .states.back()
                    .x;
    scene.fewest = random.whole(600, 1200);
    scene.wanted = scene.error(scene.fewest);
    const double quarter = scene.error(scene.fewest / 4) * (scene.fewest / 4) / scene.fewest;
    if (std::abs(quarter / scene.wanted - 1) < 0.01) return scene;
  }
}

}  // namespace scene
