// SPDX-License-Identifier: MIT-0
/// @file
/// The scenes for which steps are wanted.
#pragma once
#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "harness.h"
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

/// The kind of a scene, from which it is drawn.
struct Kind {
  double duration;
  int least = 600, most = 1200;           ///< of the steps that it takes
  double push = 1;                        ///< times that of the others
  std::optional<double> from{}, speed{};  ///< how far from the origin it begins, and how fast
};

inline judge::Start start(judge::Random& random, const Kind& kind) {
  judge::Start start = random.start();
  const auto long_as = [&](double size) {
    return size > 0 ? random.vector_anywhere({"size", size, size}) : Vec{};
  };
  if (kind.from) start.x = long_as(*kind.from);
  if (kind.speed) start.v = long_as(*kind.speed);
  start.t = 0;
  return start;
}

/// A scene in which the error goes with the step, within a hundredth, from a quarter of the steps
/// on and already from 150, so that a good guess can be made from shorter runs.
inline Scene draw(judge::Random& random, const Kind& kind) {
  for (;;) {
    const harness::Force force = random.wild();
    const judge::Waves gusts{random, 0.5, 3, 3};
    const double push = kind.push;
    Scene scene{
        [=](const Vec& x, const Vec& v, double t) { return push * (force(x, v, t) + gusts(x, t)); },
        start(random, kind),
        kind.duration,
        {},
        0,
        0};
    constexpr int fine = 512;  // more than enough of a far better method
    scene.end =
        judge::run(judge::rk4, scene.start, scene.duration / fine, fine, fine, scene.acceleration)
            .states.back()
            .x;
    scene.fewest = random.whole(kind.least, kind.most);
    scene.wanted = scene.error(scene.fewest);
    const int few = std::min(scene.fewest / 4, 150);
    const double guess = scene.error(few) * few / scene.fewest;
    if (std::abs(guess / scene.wanted - 1) < 0.01) return scene;
  }
}

/// So many scenes, of which every two last equally long: from at rest at the origin to far away or
/// fast, under a push that is weak or strong, and with ever more steps to take.
inline std::vector<Scene> all_kinds(judge::Random& random, int count) {
  constexpr double least = 150, most = 3000, weakest = 1e-4;
  std::vector<Scene> scenes;
  double duration = 0;
  for (int n = 0; n < count; ++n) {
    if (n % 2 == 0) duration = random.anywhere(harness_bounds::duration);
    const auto steps = [&](int of) { return least * std::pow(most / least, 1.0 * of / count); };
    const auto smaller = [](const harness::Bounds& bounds, int decades) {
      return bounds.largest() * std::pow(10, -decades);
    };
    Kind kind{duration,
              static_cast<int>(steps(n)),
              static_cast<int>(steps(n + 1)),
              n + 1 == count ? weakest : random.octaves(weakest, 1),
              smaller(harness_bounds::x, n - 1),
              smaller(harness_bounds::v, count - 1 - n)};
    if (n == 0) kind.from = kind.speed = 0;
    scenes.push_back(draw(random, kind));
  }
  return scenes;
}

}  // namespace scene
