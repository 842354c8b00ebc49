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
#include "measure/methods.h"
#include "measure/run.h"
#include "shelf/fixed_step.h"

inline constexpr double tolerance = 1e-6;  ///< largest estimate of a step's error [m] or [m/s]

/// What a passage of the comet took.
struct Passage {
  std::vector<long> evaluations;              ///< of each frame
  scenes::State<scenes::Orbit<>::Vec> end{};  ///< where it was one year after the start
  double error = 0;                           ///< its distance from where it should be [m]
  double farthest = 0;                        ///< the same in the worst of the frames [m]

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
inline Passage pass(long frames,
                    scenes::State<scenes::Orbit<>::Vec> s = comet.exact(-comet_year / 2)) {
  const measure::Counted counted{comet};
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
  }
  passage.end = s;
  passage.error = (s.x - comet.exact(comet_year / 2).x).norm();
  return passage;
}

/// Follows the comet for the same year along a path that runs ahead of the frames.
/// @param frames  how many; they are read out of the path, and cut none of its steps
inline Passage read(long frames) {
  const measure::Counted counted{comet};
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

/// Where RK4 leaves the comet after the same year, in steps of a thousandth of a second out of
/// equal frames.
/// @param frames  frames per second
inline scenes::State<scenes::Orbit<>::Vec> end_of_fixed_steps(long frames) {
  auto s = comet.exact(-comet_year / 2);
  shelf::FixedStep<> clock{.h = 1.0 / 1000};
  const long steps = std::lround(comet_year / clock.h);
  while (clock.steps < steps) {
    clock.frame(1.0 / double(frames), [&](double t) {
      if (clock.steps <= steps) measure::rk4(s.x, s.v, t, clock.h, comet);
    });
  }
  return s;
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
    (std::max(error.x.norm(), error.v.norm()) <= tolerance ? good : too_long) = step;
  }
  return good;
}

/// What the passage costs, in one go and in frames, and what equal steps would have cost.
inline void comet_passes(measure::Record& record) {
  const Passage smooth = pass(1), framed = pass(1200);
  record.number("comet-free", double(smooth.total()), measure::whole);
  record.number("comet-framed", double(framed.total()), measure::whole);
  record.number("comet-dearest", double(framed.dearest()), measure::whole);
  record.number("comet-cheapest", double(framed.cheapest()), measure::whole);
  record.number("comet-error", 1e6 * smooth.error, 2, "µm");
  record.number("comet-read", 1e6 * read(1200).farthest, 2, "µm");
  record.number("comet-longest", longest_step(), 2, "s");
  long rate = 60;
  while (error_of_equal_steps(rate) > smooth.error) rate += 60;
  record.number("comet-rk4", double(4 * rate) * comet_year, 2);
  record.number("comet-rk4-rate", double(rate), measure::whole);
  record.number("comet-rk4-60", error_of_equal_steps(60), 2, "m");
  const auto fixed = end_of_fixed_steps(60);
  record.number("comet-fixed-frame", 4 * 1000.0 / 60, 2);
  record.number("comet-fixed", 4 * 1000 * comet_year, measure::whole);
  record.number("comet-fixed-error", 1000 * (fixed.x - comet.exact(comet_year / 2).x).norm(), 2,
                "mm");
  record.number("comet-apart", 1e6 * (framed.end.x - pass(2880).end.x).norm(), 2, "µm");

  auto& table = record.table("comet", {{"t", "s"}, {"evaluations", "", measure::whole}});
  for (std::size_t n = 0; n < framed.evaluations.size(); ++n) {
    table.add({double(n) / 60, double(framed.evaluations[n])});
  }
}
