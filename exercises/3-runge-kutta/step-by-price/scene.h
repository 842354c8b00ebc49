// SPDX-License-Identifier: MIT-0
/// @file
/// Flights, and where they end.
#pragma once
#include <cmath>
#include <numbers>
#include <string>

#include "harness.h"
#include "judge/describe.h"
#include "judge/method.h"
#include "judge/random.h"
#include "judge/waves.h"

namespace judge::step_by_price {

struct Scene {
  std::string name;
  Start start;
  double duration = 0;
  Acceleration acceleration;
  State end;      // the truth
  double mu = 0;  // of a sun
};

/// Past the sun, among planets that tug: from an angle of its ellipse, as seen from the middle, to
/// another on the other side.
inline Scene comet(Random& random, double from, double to) {
  const double e = random.between(0.94, 0.97), a = random.between(80, 120);
  const double rate = 2 * std::numbers::pi / random.between(15, 25), mu = a * a * a * rate * rate;
  const double tilt = random.between(0.2, 1.2);
  const Vec across{0, std::cos(tilt), std::sin(tilt)};
  const auto at = [&](double angle) {
    const double b = a * std::sqrt(1 - e * e), turning = rate / (1 - e * std::cos(angle));
    return State{Vec{a * (std::cos(angle) - e), 0, 0} + (b * std::sin(angle)) * across,
                 turning * (Vec{-a * std::sin(angle), 0, 0} + (b * std::cos(angle)) * across)};
  };
  const State before = at(-from);
  const harness::Force sun{harness::Force::orbit, {mu}};
  const Waves planets{random, 0.02 * a * rate * rate, a, 2 * std::numbers::pi / rate};
  Scene scene{"a comet on " + describe(sun) + ", and planets that only the judge knows",
              {before.x, before.v, 0},
              (from + to - e * (std::sin(from) + std::sin(to))) / rate,
              [=](const Vec& x, const Vec& v, double t) { return sun(x, v, t) + planets(x, t); },
              {},
              mu};
  scene.end = truth_past_a_sun(scene.start, scene.duration, mu, scene.acceleration);
  return scene;
}

/// A comet to about the same position on the other side.
inline Scene comet(Random& random) {
  const double angle = random.between(2.2, 2.9);
  return comet(random, angle, angle);
}

/// The questions of the fewest equal steps of RK4, to a twentieth, that end as near.
inline double equal_steps(const Scene& scene, double off) {
  for (int steps = 100;; steps += steps / 20) {
    const Path path =
        run(rk4, scene.start, scene.duration / steps, steps, steps, scene.acceleration);
    if (distance(path.states.back(), scene.end) <= off) return 4.0 * steps;
  }
}

inline Scene wind(const harness::Force& force, const Start& start, double duration) {
  Scene scene{describe(force), start, duration, force, {}};
  scene.end = truth(scene.start, scene.duration, 1, 1, force).states.back();
  return scene;
}

constexpr harness::Force nothing{harness::Force::falling, {}};

inline Scene coast(const Start& start, double duration) {
  return {"a probe that nothing pulls",
          start,
          duration,
          nothing,
          {start.x + duration * start.v, start.v}};
}

/// A start at any position and velocity, none too.
inline Start anywhere(Random& random) {
  return {random.vector_anywhere(harness_bounds::place),
          random.vector_anywhere(harness_bounds::velocity), random.anywhere(harness_bounds::time)};
}

/// A start from the origin, by powers of two: however long a first step is, nothing of it is
/// rounded, and its estimate is zero.
inline Start without_rounding(Random& random) {
  const auto power = [&] {
    const double sign = random.sign();
    return std::ldexp(sign, random.whole(-2, 1));
  };
  const double x = power(), y = power(), z = power();
  return {{}, {x, y, z}, 0};
}

}  // namespace judge::step_by_price
