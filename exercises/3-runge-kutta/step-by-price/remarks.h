// SPDX-License-Identifier: MIT-0
/// @file
/// Diagnoses of a flight's steps, from its questions; and of a wrong moment of a comet's pass.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "format_values.h"
#include "judge/method.h"

namespace judge::step_by_price {

using Signs = std::vector<std::string>;

inline Signs either(const Signs& one, const Signs& other) {
  return one.empty() ? other : one;
}

/// The number of questions of a pair of half steps of RK4.
constexpr std::size_t a_step = 12;

/// The time that so many questions, from the n-th on, reach over [s].
inline double reach(const Path& path, std::size_t n) {
  const auto from = path.evaluations.begin() + static_cast<std::ptrdiff_t>(n);
  const auto [first, last] =
      std::minmax_element(from, from + std::ptrdiff_t(a_step),
                          [](const Evaluation& a, const Evaluation& b) { return a.t < b.t; });
  return last->t - first->t;
}

inline Signs spread_evenly(const Path& path, double duration) {
  constexpr std::size_t parts = 10;
  std::vector<int> counts(parts);
  for (const Evaluation& asked : path.evaluations) {
    const double part = parts * (asked.t - path.t) / duration;
    ++counts[static_cast<std::size_t>(std::clamp(part, 0.0, parts - 1.0))];
  }
  const auto [fewest, most] = std::ranges::minmax(counts);
  if (most > 2 * fewest) return {};
  return {"no tenth of the flight has twice the questions of another: all steps are as long"};
}

inline Signs asks_too_little(const Path& path) {
  if (path.evaluations.size() >= 2 * a_step) return {};
  return {"it asked " + grade::number(double(path.evaluations.size())) +
          " times in all: what pulls elsewhere, and later, nobody has told it"};
}

inline Signs coasts_in_short_steps(const Path& path, double duration) {
  double longest = 0;
  for (std::size_t n = 0; n + a_step <= path.evaluations.size(); ++n) {
    longest = std::max(longest, reach(path, n));
  }
  if (longest > duration / 10) return {};
  return {"no twelve questions reach over more than " + grade::number(longest, 2) +
          " s: let a step grow faster"};
}

/// Says how far from a moment, at which the force changes, it asked on either side.
inline Signs jumps_over(const Path& path, double moment) {
  double before = INFINITY, after = INFINITY;
  for (const Evaluation& asked : path.evaluations) {
    const double late = asked.t - moment;
    (late < 0 ? before : after) = std::min(late < 0 ? before : after, std::abs(late));
  }
  if (before + after < 0.05) return {};
  if (!std::isfinite(after)) return {"it asked nothing after the engine's start"};
  if (!std::isfinite(before)) return {"it asked nothing before the engine's start"};
  return {"its last question before the engine starts and its first one after that are " +
          grade::number(before + after, 2) + " s apart: was the step that met it made again?"};
}

/// Says whether it asked the same again and again: a step that is rejected, and tried again as it
/// was.
inline Signs asks_the_same(const Path& path) {
  constexpr std::ptrdiff_t too_often = 100;
  std::vector<std::array<double, 7>> asked;
  for (const auto& [x, v, t, a] : path.evaluations)
    asked.push_back({t, x.x, x.y, x.z, v.x, v.y, v.z});
  std::ranges::sort(asked);
  for (auto at = asked.begin(); at != asked.end();) {
    const auto next = std::upper_bound(at, asked.end(), *at);
    if (next - at > too_often)
      return {"one question was asked " + std::to_string(next - at) +
              " times: a step that is rejected has to be tried again with a shorter one"};
    at = next;
  }
  return {};
}

inline Signs clock_stands(const Path& path, double duration) {
  double latest = 0;
  for (const Evaluation& asked : path.evaluations) latest = std::max(latest, asked.t - path.t);
  if (latest > duration / 10 || path.evaluations.size() < 2 * a_step) return {};
  return {"no question is for a moment later than " + grade::number(latest, 2) +
          " s after the start: does the clock move on with each step?"};
}

inline Signs goes_past_the_end(const Path& path, double duration) {
  double latest = 0;
  for (const Evaluation& asked : path.evaluations) latest = std::max(latest, asked.t - path.t);
  const double beyond = latest - duration;
  if (beyond <= 1e-9 * duration) return {};
  return {"it asks for moments up to " + grade::number(beyond, 2) +
          " s after the end of the flight: the last step has to be cut to what is left"};
}

/// The time by which a position is further on than the true one, along the path [s].
inline double ahead(const Vec& x, const State& truly) {
  return dot(x - truly.x, truly.v) / dot(truly.v, truly.v);
}

inline Signs late_at_the_end(const State& end, const State& truly) {
  const double by = ahead(end.x, truly), off = length(end.x - truly.x);
  if (length(end.x - truly.x - by * truly.v) > off / 10) return {};
  return {"it ends on the right path, " + grade::number(std::abs(by), 2) + " s " +
          (by > 0 ? "after" : "before") + " the moment that was asked for"};
}

/// Says whether many questions name a time at which the flight is elsewhere on its path.
inline Signs asks_at_another_time(const Path& path, double duration,
                                  const Acceleration& acceleration) {
  constexpr int parts = 1000;
  const Start start{path.states.front().x, path.states.front().v, path.t};
  const Path truly = truth(start, duration / parts, parts, 1, acceleration);
  std::size_t elsewhere = 0;
  for (std::size_t n = 0; n + a_step <= path.evaluations.size(); ++n) {
    const Evaluation& asked = path.evaluations[n];
    const double part = std::clamp((asked.t - path.t) / duration, 0.0, 1.0) * parts;
    const State& near = truly.states[static_cast<std::size_t>(part)];
    const double since = (part - std::floor(part)) * duration / parts;
    const double off = ahead(asked.x, {near.x + since * near.v, near.v});
    elsewhere += std::abs(off) > 0.2 * reach(path, n);
  }
  if (6 * elsewhere < path.evaluations.size()) return {};
  return {
      "many of its questions name a time at which the flight is elsewhere: does the clock of "
      "each question go with its place?"};
}

/// The way that a comet flies from here until it is nearest to the origin, below zero if it was
/// nearest before [m]. Far out, where its distance bends the other way, it is infinite.
inline double way_to_pass(const State& comet, const Vec& a) {
  const double bends = dot(comet.v, comet.v) + dot(comet.x, a);
  return bends > 0 ? -dot(comet.x, comet.v) / bends * length(comet.v) : INFINITY;
}

/// The questions that may be paid for a pass. Steps that are chosen take 1,000 to 4,000; as near in
/// equal ones are 7,000 and more.
constexpr double questions_of_a_pass = 5000;

/// The number beyond which questions are too many, whatever comes of them.
constexpr double patience_for_a_pass = 20'000;

/// The answer for a pass.
struct Given {
  double start, duration;  ///< of the flight [s]
  double time;             ///< that was said [s]
  double off;              ///< the way from there to the pass [m]
  double off_since;        ///< the same, if the time counts from the start [m]
  double price;            ///< questions, as a share of what is allowed
  bool cut_off;            ///< whether there were so many that nothing pulled any more
};

/// Returns whether a question was for just this time.
inline bool asked_at(const Path& path, double time) {
  for (const Evaluation& asked : path.evaluations)
    if (std::abs(asked.t - time) <= 1e-12 * time) return true;
  return false;
}

inline Signs why_not_the_pass(const Given& given, const Path& path, double bound) {
  const double since = given.time - given.start;
  if (!std::isfinite(given.time)) return {"this is not a finite time"};
  if (given.time == given.start) return {"this is the moment at which the flight begins"};
  if (given.cut_off)
    return {"after " + grade::number(patience_for_a_pass) +
            " questions the judge let nothing pull any more, and the time is worth nothing: no "
            "guess within a step needs the flight again"};
  if (given.price > 1)
    return {"this costs " + grade::number(given.price, 3) +
            " times what it may: no guess within a step needs the flight again, and no step need "
            "be as short as the shortest"};
  if (std::abs(since - given.duration / 2) <= 1e-9 * given.duration)
    return {"this is the middle of the flight, where nothing but a sun would have it turn"};
  if (std::abs(given.off_since) <= bound)
    return {"this is the time since the start: is t left out?"};
  if (!(since > 0 && since < given.duration)) return {"this time is not within the flight"};
  if (std::abs(given.off) > bound && asked_at(path, given.time))
    return {given.off > 0 ? "this is where a step begins; the comet turns within it"
                          : "this is where a step ends; the comet turns within it"};
  if (!std::isfinite(given.off)) return {"at that time the comet is still far out, or again"};
  if (std::abs(given.off) > bound)
    return {"the comet turns " + grade::number(std::abs(given.off), 2) + " m of its way " +
            (given.off > 0 ? "later" : "earlier") +
            ": was the moment that you found tried by a step of its own, and mended?"};
  return {};
}

}  // namespace judge::step_by_price
