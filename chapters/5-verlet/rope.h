// SPDX-License-Identifier: MIT-0
/// @file
/// A rope of points and links, moved by position Verlet.
#pragma once
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "integrate/stormer_verlet.h"

using Vec = Eigen::Vector2d;

inline constexpr auto gravity = [](const Vec&, const Vec&, double) -> Vec { return {0, -9.81}; };

// [rope]
struct Rope {
  std::vector<Vec> x, x_previous;
  double link;  // length of each link [m]
  void pull(std::size_t i) {
    const Vec d = x[i] - x[i - 1];
    const Vec excess = (1 - link / d.norm()) * d;
    const double share = i == 1 ? 0 : 0.5;  // the first point is held
    x[i - 1] += share * excess;
    x[i] -= (1 - share) * excess;
  }

  void step(double h, int iterations) {
    for (std::size_t i = 1; i < x.size(); ++i) {
      integrate::stormer_verlet(x[i], x_previous[i], 0.0, h, gravity);
    }
    for (; iterations > 0; --iterations) {
      for (std::size_t i = 1; i < x.size(); ++i) pull(i);
    }
  }
};
// [rope]

/// Two metres of rope at rest, from the origin in some direction.
inline Rope two_metres(int links, const Vec& direction) {
  Rope rope{{}, {}, 2.0 / links};
  for (int i = 0; i <= links; ++i) rope.x.push_back(i * rope.link * direction);
  rope.x_previous = rope.x;
  return rope;
}

/// How much longer than it should be [share].
inline double stretch(const Rope& rope) {
  double length = 0;
  for (std::size_t i = 1; i < rope.x.size(); ++i) length += (rope.x[i] - rope.x[i - 1]).norm();
  return length / (rope.link * double(rope.x.size() - 1)) - 1;
}

/// How far a rope that hangs is stretched when it has come to rest [share].
inline double hanging(int links, double h, int iterations) {
  Rope rope = two_metres(links, {0, -1});
  double before = INFINITY, now = 0;
  for (int minute = 0; minute < 60 && std::abs(now - before) > 1e-6; ++minute) {
    for (int n = 0; n * h < 60; ++n) rope.step(h, iterations);
    before = std::exchange(now, stretch(rope));
  }
  return now;
}

/// How far a rope that falls from a level start is stretched at its worst in five seconds [share].
inline double falling(int links, double h, int iterations) {
  Rope rope = two_metres(links, {1, 0});
  double most = 0;
  for (int n = 0; n * h < 5; ++n) {
    rope.step(h, iterations);
    most = std::max(most, stretch(rope));
  }
  return most;
}
