// SPDX-License-Identifier: MIT-0
/// @file
/// A rope that hangs straight down, and what a plan for it costs.
#pragma once
#include <cmath>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

#include "format_values.h"

namespace judge::verlet {

inline constexpr double gravity = 9.81;  ///< [m/s^2]

/// So many substeps of a frame, and iterations in each.
struct Split {
  int substeps = 1, iterations = 1;

  std::string in_words() const {
    return "substeps = " + std::to_string(substeps) +
           ", iterations = " + std::to_string(iterations);
  }
};

/// The chapter's rule of thumb for a rope's stretch [m].
inline double rule(int links, double frame, const Split& split) {
  const double h = frame / split.substeps;
  return gravity * h * h * links * links / (2.0 * split.iterations);
}

/// What there is to say of a stretch that is not the rule's.
inline std::vector<std::string> why_foretold(double got, int links, double frame,
                                             const Split& split) {
  if (got == 0) return {"this is nothing: a division of integers, such as 1 / 2?"};
  const double n = links, substeps = split.substeps, step = frame / substeps;
  const std::pair<double, const char*> known[] = {
      {1 / n, "the links count once"},
      {1 / step, "the step counts once"},
      {substeps, "the step counts once, and beside it stands a whole frame"},
      {substeps * substeps, "the frame is not split"},
      {split.iterations, "the iterations don't count"},
      {1.0 / split.iterations, "the iterations count twice"},
      {2, "twice what the rule says"},
      {0.5, "half of what the rule says"},
      {1 / gravity, "gravity is missing"},
  };
  for (const auto& [factor, says] : known) {
    if (std::abs(got / rule(links, frame, split) / factor - 1) < 1e-10) return {says};
  }
  return {};
}

/// The stretch of the chapter's rope, hung up and left alone for a minute [m]. It hangs along one
/// axis, so one number a point will do.
inline double hung_up(int links, double frame, const Split& split) {
  const double h = frame / split.substeps;
  const auto n = static_cast<std::size_t>(links);
  std::vector<double> excess(n + 1, 0.0), previous = excess;  // how far each point is too low [m]
  for (int step = 0; step * h < 60; ++step) {
    for (std::size_t i = 1; i <= n; ++i) {
      const double next = 2 * excess[i] - previous[i] + gravity * h * h;
      previous[i] = excess[i];
      excess[i] = next;
    }
    for (int k = 0; k < split.iterations; ++k) {
      excess[1] = 0;
      for (std::size_t i = 2; i <= n; ++i)
        excess[i] = excess[i - 1] = (excess[i] + excess[i - 1]) / 2;
    }
  }
  return excess[n];
}

/// A curtain and its prices.
struct Curtain {
  int links = 30;
  double frame = 1.0 / 60;    ///< [s]
  double most = 0.05;         ///< that it may stretch [m]
  double move = 1, pull = 1;  ///< prices [us]

  double price(const Split& split) const {
    return split.substeps * (move + split.iterations * pull);
  }

  /// The cheapest that the rule allows with so many iterations.
  Split with(int iterations) const {
    Split split{1, iterations};
    while (rule(links, frame, split) > most) ++split.substeps;
    return split;
  }

  /// The cheapest that the rule allows.
  Split best() const {
    Split best = with(1);
    for (int iterations = 2; iterations <= links; ++iterations) {
      if (price(with(iterations)) < price(best)) best = with(iterations);
    }
    return best;
  }

  /// What can be said of a plan that is too dear.
  std::vector<std::string> why_dear(const Split& yours) const {
    const int iterations = best().iterations;
    std::vector<std::string> said;
    if (yours.iterations == 1 && iterations > 1) {
      said.push_back("a single iteration: each substep pays for its move again");
    }
    if (yours.substeps == 1 && best().substeps > 1) {
      said.push_back("a single substep: iterations count once in the rule, substeps twice");
    }
    if (yours.iterations <= links && yours.substeps > with(yours.iterations).substeps) {
      said.push_back("with so many iterations fewer substeps will do: " +
                     std::to_string(with(yours.iterations).substeps));
    }
    if (std::abs(yours.iterations - iterations) == 1) {
      said.push_back("near: substeps are whole numbers, so try the neighbours, too");
    }
    return said;
  }

  std::string in_words() const {
    const auto full = [](double value) { return grade::number(value, 17); };
    return "links = " + std::to_string(links) + ", frame = " + full(frame) +
           ", most = " + full(most) + ", move = " + full(move) + ", pull = " + full(pull);
  }
};

}  // namespace judge::verlet
