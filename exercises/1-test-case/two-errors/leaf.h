// SPDX-License-Identifier: MIT-0
/// @file
/// A leaf that falls, and for which there is a formula.
#pragma once
#include <algorithm>
#include <cmath>

#include "judge/method.h"
#include "judge/random.h"

/// What a falling leaf is off by when it is stepped: the largest error of four seconds [m].
struct Leaf {
  harness::Force force;
  judge::Start start;
  double duration = 4;

  static Leaf draw(judge::Random& random) {
    return {{harness::Force::falling, {random.between(5, 12), random.between(0.8, 1.6)}},
            {random.vector(1, 3), random.vector(-2, 2), 0}};
  }

  double height_at(double t) const {
    const double g = force.a[0], c = force.a[1], last = -g / c;
    return start.x.y + last * t + (start.v.y - last) * (1 - std::exp(-c * t)) / c;
  }

  double error(const judge::Method& method, int steps) const {
    const double h = duration / steps;
    const judge::Path path = judge::run(method, start, h, steps, 1, force);
    double largest = 0;
    for (std::size_t n = 1; n < path.states.size(); ++n) {
      largest = std::max(largest, std::abs(path.states[n].x.y - height_at(path.time(n))));
    }
    return largest;
  }
};
