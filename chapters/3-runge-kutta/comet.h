// SPDX-License-Identifier: MIT-0
/// @file
/// The comet of chapter 3, followed by a method that chooses its own steps.
#pragma once
#include <algorithm>
#include <cmath>
#include <vector>

#include "../cast.h"
#include "integrate/dopri5.h"
#include "measure/evaluations.h"
#include "measure/methods/runge_kutta.h"
#include "measure/run.h"
#include "shelf/fixed_step.h"

inline constexpr double micrometre = 1e-6;  ///< the tolerance, if no other is named [m] or [m/s]

inline constexpr double millisecond = 1e-3;  ///< the length of equal steps [s]

using CometState = scenes::State<scenes::Orbit<>::Vec>;  ///< where it is, and its velocity
using CountedComet = measure::Counted<scenes::Orbit<>>;  ///< one that counts its evaluations

/// What a passage of the comet took.
struct Passage {
  std::vector<long> evaluations;   ///< of each frame
  std::vector<CometState> frames;  ///< where it was at the end of each
  CometState end{};                ///< where it was one year after the start
  double error = 0;                ///< its distance from where it should be [m]
  double farthest = 0;             ///< the same in the worst of the frames [m]

  /// Evaluations of the acceleration in all frames.
  long total() const {
    long sum = 0;
    for (const long asked : evaluations) sum += asked;
    return sum;
  }
  /// Evaluations of the acceleration in the dearest frame.
  long dearest() const { return *std::max_element(evaluations.begin(), evaluations.end()); }
  /// Evaluations of the acceleration in the cheapest frame.
  long cheapest() const { return *std::min_element(evaluations.begin(), evaluations.end()); }
};

/// Follows the comet for a year, from its far end past the sun and back, in equal frames.
/// @param frames  how many; in each, Dormand-Prince takes the steps that it needs
/// @param s  where the comet starts
/// @param tolerance  largest estimate of a step's error [m] or [m/s]
/// @param counted  the comet, which may note more than how often it is asked
template <class Comet = CountedComet>
Passage pass(long frames, CometState s = comet.exact(-comet_year / 2),
             double tolerance = micrometre, const Comet& counted = Comet{comet}) {
  const double length = comet_year / double(frames);
  Passage passage;
  double next = length;
  const auto size = [](const auto& error) { return error.norm(); };
  for (long n = 0; n < frames; ++n) {
    const double t = double(n) * length;
    const long before = counted.evaluations;
    // [frame]
    const bool there =
        integrate::dopri5_adaptive(s.x, s.v, t, length, next, counted, size, tolerance);
    // [frame]
    passage.evaluations.push_back(there ? counted.evaluations - before : -1);
    passage.frames.push_back(s);
  }
  passage.end = s;
  passage.error = (s.x - comet.exact(comet_year / 2).x).norm();
  return passage;
}

/// Follows the comet for the same year along a path that runs ahead of the frames.
/// @param frames  how many; they are read out of the path, and cut none of its steps
/// @param tolerance  largest estimate of a step's error [m] or [m/s]
/// @param counted  the comet, which may note more than how often it is asked
template <class Comet = CountedComet>
Passage read(long frames, double tolerance = micrometre, const Comet& counted = Comet{comet}) {
  auto s = comet.exact(-comet_year / 2);
  auto path = integrate::dopri5_path(s.x, s.v, 0.0, comet_year, counted);
  Passage passage;
  const auto size = [](const auto& error) { return error.norm(); };
  for (long n = 1; n <= frames; ++n) {
    const double t = comet_year * double(n) / double(frames);
    const long before = n > 1 ? counted.evaluations : 0;
    // [ahead]
    const bool there = integrate::dopri5_adaptive(path, t, counted, size, tolerance);
    s = {path.position(t), path.velocity(t)};
    // [ahead]
    passage.evaluations.push_back(there ? counted.evaluations - before : -1);
    passage.frames.push_back(s);
    passage.error = (s.x - comet.exact(t - comet_year / 2).x).norm();
    passage.farthest = std::max(passage.farthest, passage.error);
  }
  passage.end = s;
  return passage;
}

/// Where RK4 leaves the comet after the same year, measured from where it should be [m].
/// @param rate  steps per second
inline double error_of_equal_steps(long rate) {
  const auto end = measure::after(measure::rk4, comet, comet.exact(-comet_year / 2),
                                  1.0 / double(rate), std::lround(comet_year * double(rate)));
  return (end.x - comet.exact(comet_year / 2).x).norm();
}

/// Follows the comet for the same year by RK4, in steps of a thousandth of a second out of equal
/// frames.
/// @param frames  how many
/// @param counted  the comet, which may note more than how often it is asked
template <class Comet = CountedComet>
Passage step_equally(long frames, const Comet& counted = Comet{comet}) {
  auto s = comet.exact(-comet_year / 2);
  const double length = comet_year / double(frames);
  shelf::FixedStep<> clock{.h = millisecond};
  const long steps = std::lround(comet_year / clock.h);
  Passage passage;
  while (clock.steps < steps) {
    const long before = counted.evaluations;
    // [equal]
    clock.frame(length, [&](double t) {
      if (clock.steps <= steps) measure::rk4(s.x, s.v, t, clock.h, counted);
    });
    // [equal]
    passage.evaluations.push_back(counted.evaluations - before);
    passage.frames.push_back(s);
  }
  passage.end = s;
  passage.error = (s.x - comet.exact(comet_year / 2).x).norm();
  return passage;
}

/// The longest step at the comet's far end that stays within the tolerance [s].
inline double longest_step() {
  const auto far = comet.exact(-comet_year / 2);
  double good = 1e-3, too_long = comet_year / 2;
  for (int halving = 0; halving < 40; ++halving) {
    const double step = (good + too_long) / 2;
    auto s = far;
    auto a = integrate::dopri5_start(s.x, s.v, 0.0, comet);
    const auto error = integrate::dopri5(s.x, s.v, a, 0.0, step, comet);
    (std::max(error.x.norm(), error.v.norm()) <= micrometre ? good : too_long) = step;
  }
  return good;
}
