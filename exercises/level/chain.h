// SPDX-License-Identifier: MIT-0
#pragma once
#include <algorithm>
#include <cmath>
#include <vector>

#include "judge/numbers.h"
#include "part.h"

namespace level {

/// A lantern on a chain of two links, each pulled twice a step.
struct Chain {
  static constexpr int links = 2, pulls = 2;
  static constexpr double longest = 0.6, shortest = 0.5, drag = 0.3, gust = 1.5;
  static constexpr double inverse[links + 1] = {0, 4, 1};
  Vec x[links + 1], before[links + 1];

  Chain() {
    for (int i = 0; i <= links; ++i) x[i] = before[i] = longest * i * Vec{0.39, -0.92, 0};
  }

  void step(judge::Student& whose, double time) {
    for (int i = 1; i <= links; ++i) {
      const Vec v = (x[i] - before[i]) / h;
      const Vec wind{gust * std::sin(time), 0, 0};
      const Vec next = 2 * x[i] - before[i] + h * h * (Vec{0, -9.81, 0} + wind - drag * v);
      before[i] = x[i];
      x[i] = next;
    }
    for (int n = 0; n < pulls; ++n) {
      for (int i = 1; i <= links; ++i) {
        const auto asked =
            judge::as_numbers(x[i - 1], x[i], shortest, longest, inverse[i - 1], inverse[i]);
        const std::vector<Vec> ends = judge::as_vectors(whose.call(0, asked, 6));
        x[i - 1] = ends[0];
        x[i] = ends[1];
      }
    }
  }

  /// By how much a link is too long or too short, or has left its nail.
  double off() const {
    double most = length(x[0]);
    for (int i = 0; i < links; ++i) {
      const double now = length(x[i + 1] - x[i]);
      most = judge::larger(most, std::max(now - longest, shortest - now));
    }
    return most;
  }
};

}  // namespace level
