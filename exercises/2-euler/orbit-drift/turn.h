// SPDX-License-Identifier: MIT-0
/// @file
/// A drone that flies once around its tower in steps of Euler's method.
#pragma once
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "format_values.h"
#include "judge/method.h"
#include "judge/random.h"

namespace drone {

constexpr int most_steps = 200000;  ///< that the judge will fly

/// How far out the drone is after so many steps, and where it was on the way there.
/// @param angle  that all of them cover on the circle of one metre
inline judge::Path fly(int steps, double angle = 2 * std::numbers::pi) {
  const harness::Force leash{harness::Force::spring, {1, 0}};
  return judge::run(judge::euler, {{1, 0, 0}, {0, 1, 0}, 0}, angle / steps, steps, 1, leash);
}

/// The share by which the distance has grown then; without end if there is no step.
inline double growth(int steps, double angle = 2 * std::numbers::pi) {
  if (steps < 1 || steps > most_steps) return steps < 1 ? INFINITY : 0;
  return length(fly(steps, angle).states.back().x) - 1;
}

/// What the designer allows, and the fewest steps that stay within it.
struct Turn {
  double growth;
  int fewest;

  /// Of a share that is given.
  static Turn of(double growth) {
    int beyond = 0, within = most_steps;
    while (within - beyond > 1) {
      const int steps = (beyond + within) / 2;
      (drone::growth(steps) > growth ? beyond : within) = steps;
    }
    return {growth, within};
  }

  /// Well between what the fewest steps and one fewer do, so that rounding can't choose.
  static Turn draw(judge::Random& random, double low, double high) {
    const int steps = static_cast<int>(std::exp(random.between(std::log(low), std::log(high))));
    const double within = drone::growth(steps), beyond = drone::growth(steps - 1);
    return {within + random.between(0.2, 0.8) * (beyond - within), steps};
  }
};

/// Whether so many are the fewest that keep something that they do to `most`.
template <class Does>
bool fewest(int steps, double most, Does does) {
  return does(steps) <= most && does(steps - 1) > most;
}

/// What may have been counted instead.
inline std::vector<std::string> recognise(const Turn& turn, int steps) {
  constexpr double around = 2 * std::numbers::pi;
  const auto is_fewest = [&](double most, auto does) { return fewest(steps, most, does); };
  const auto once = [](int n) { return growth(n); };
  const auto one_step = [](int n) { return n < 1 ? INFINITY : growth(1, around / n); };
  const auto added = [=](int n) { return n * one_step(n); };
  const auto tangents = [](int n) { return n < 1 ? INFINITY : around / n * around / 2; };
  const auto energy = [](int n) { return std::pow(1 + growth(n), 2) - 1; };
  const auto radian = [](int n) { return growth(n, 1); };
  const double of_many = 2 * std::numbers::pi * std::numbers::pi / std::log1p(turn.growth);
  if (steps < 1) return {"this is no number of steps: " + std::to_string(steps)};
  if (is_fewest(turn.growth, added) || is_fewest(turn.growth, tangents))
    return {
        "this adds up by how much each step grows the distance; but each step grows what the "
        "one before has left, so these factors multiply"};
  if (is_fewest(turn.growth, energy))
    return {"so many steps keep the energy within this share, and not the distance"};
  if (is_fewest(turn.growth, one_step))
    return {"so many keep every single step within this share, and not the turn"};
  if (steps == 1)
    return {
        "a single step for the whole turn: is this for the way of one radian, or are whole numbers "
        "divided?"};
  if (is_fewest(turn.growth, radian))
    return {"this is right for the way of one radian; once around there are 2 pi of them"};
  if (is_fewest(100 * turn.growth, once) || is_fewest(turn.growth / 100, once))
    return {"this is off by a hundred: a growth of 0.01 is one per cent"};
  if (steps == std::ceil(of_many))
    return {
        "this is right for a turn of very many steps, where log(1 + x) is nearly x; here they are "
        "few"};
  if (steps == turn.fewest - 1) return {"one step too few: did you round down?"};
  if (steps == turn.fewest + 1) return {"one step too many: it can be spared"};
  if (steps > turn.fewest && (steps & (steps - 1)) == 0)
    return {"a power of two: the fewest steps lie between this and its half"};
  return {};
}

}  // namespace drone
