// SPDX-License-Identifier: MIT-0
// What flies by itself: the shuttle.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "judge/method.h"
#include "things.h"

namespace level {

Hour shuttle_hour(judge::Student& yours, judge::Student&) {
  constexpr int flights = 60;
  constexpr double mu = 1, flatness = 0.002;
  Hour hour;
  Drawn drawn;
  for (int n = 1; n <= flights; ++n) {
    const double eccentricity = drawn.between(0.78, 0.82), tilt = drawn.between(0.2, 1.2);
    const double nearest = 1 - eccentricity;
    const double speed = std::sqrt(mu * (1 + eccentricity) / nearest);
    const judge::Start start{{nearest, 0, 0}, {0, speed * std::cos(tilt), speed * std::sin(tilt)}};
    const Acceleration planet = [](const Vec& x, const Vec&, double) {
      const double r2 = dot(x, x);
      return (-mu / (r2 * std::sqrt(r2)) * (1 + flatness / r2)) * x;
    };
    const double seconds = 2 * std::numbers::pi / std::sqrt(mu);
    const judge::Path path = yours.watch(start, seconds, 1, planet);
    const judge::State truth = judge::truth_past_a_sun(start, seconds, mu, planet);
    const double off = length(path.states.back().x - truth.x);
    hour.hold(off, "flight " + std::to_string(n));
    hour.evaluations =
        std::max(hour.evaluations, static_cast<double>(path.evaluations.size()) / (60 * seconds));
  }
  return hour;
}

}  // namespace level
