// SPDX-License-Identifier: MIT-0
/// @file
/// A rope that hangs straight down, and what a plan for it costs.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

#include "judge/describe.h"

namespace judge::verlet::pulls_for_a_curtain {

inline constexpr double gravity = 9.81;  ///< [m/s^2]

/// A number of substeps of a frame, and iterations in each.
struct Split {
  int substeps = 1, iterations = 1;

  bool operator==(const Split&) const = default;

  std::string in_words() const { return named("substeps", substeps, "iterations", iterations); }
};

/// The chapter's rule of thumb for a rope's stretch [m].
inline double rule(int links, double frame, const Split& split) {
  const double h = frame / split.substeps;
  return gravity * h * h * links * links / (2.0 * split.iterations);
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

  std::string in_words() const {
    return named("links", links, "frame", frame, "most", most, "move", move, "pull", pull);
  }
};

inline double by_rule(const Curtain& of, const Split& split) {
  return rule(of.links, of.frame, split);
}
inline double by_price(const Curtain& of, const Split& split) {
  return of.price(split);
}

/// A way to a plan: what is taken for the stretch and for the price, and what for the substeps.
struct Way {
  double (*stretch)(const Curtain&, const Split&) = by_rule;
  double (*price)(const Curtain&, const Split&) = by_price;
  int too_few = 0;              ///< substeps
  bool to_the_nearest = false;  ///< whole number, and not up

  /// The cheapest with so many iterations.
  Split with(const Curtain& of, int so_many) const {
    Split split{1, so_many};
    while (stretch(of, split) > of.most) ++split.substeps;
    const double below = split.substeps - 0.5;
    if (to_the_nearest && stretch(of, {1, so_many}) < of.most * below * below) --split.substeps;
    split.substeps = std::max(1, split.substeps - too_few);
    return split;
  }

  Split best(const Curtain& of) const {
    Split best = with(of, 1);
    for (int so_many = 2; so_many <= of.links; ++so_many) {
      const Split next = with(of, so_many);
      if (price(of, next) < price(of, best)) best = next;
    }
    return best;
  }
};

inline const Way right{};

// Mistaken stretches and prices.
inline double step_once(const Curtain& of, const Split& split) {
  return by_rule(of, split) * split.substeps;
}
inline double one_link_less(const Curtain& of, const Split& split) {
  return by_rule(of, split) * (1 - 1.0 / of.links);
}
inline double shared(const Curtain& of, const Split& split) {
  return split.substeps * of.move + split.iterations * of.pull;
}
/// Some plans of these are right by luck.
inline const std::vector<Way> often_right{
    {step_once}, {by_rule, by_price, 1}, {by_rule, by_price, 0, true}};

/// Diagnoses of a single plan that is too dear, or does not hold.
inline std::vector<std::string> why_wrong(const Curtain& of, const Split& yours) {
  std::vector<std::string> said;
  if (yours.iterations == 1 && right.best(of).iterations > 1) {
    said.push_back("a single iteration: each substep pays for its move again");
  }
  if (yours.substeps == 1 && right.best(of).substeps > 1) {
    said.push_back("a single substep: iterations count once in the rule, substeps twice");
  }
  if (yours.iterations > of.links) return said;
  const int enough = right.with(of, yours.iterations).substeps;
  if (yours.substeps > enough) {
    said.push_back("with so many iterations fewer substeps will do: " + std::to_string(enough));
  }
  if (yours.substeps < enough) {
    said.push_back(
        "by the rule it does not hold: with so many iterations it takes more substeps, " +
        std::to_string(enough));
  }
  return said;
}

}  // namespace judge::verlet::pulls_for_a_curtain
