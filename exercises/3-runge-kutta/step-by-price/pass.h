// SPDX-License-Identifier: MIT-0
/// @file
/// What a wrong moment of a comet's pass often is.
#pragma once
#include <cmath>

#include "signs.h"

namespace judge::step_by_price {

/// The way that a comet flies from here until it is nearest to the origin, below zero if it was
/// nearest before [m]. Far out, where its distance bends the other way, it is infinite.
inline double way_to_pass(const State& comet, const Vec& a) {
  const double bends = dot(comet.v, comet.v) + dot(comet.x, a);
  return bends > 0 ? -dot(comet.x, comet.v) / bends * length(comet.v) : INFINITY;
}

/// So many may be paid for a pass. Steps that are chosen take 1,000 to 4,000; as near in equal ones
/// are 7,000 and more.
constexpr double questions_of_a_pass = 5000;

/// Whoever asks more has asked too much, whatever comes of it.
constexpr double patience_for_a_pass = 20'000;

/// What was said of a pass.
struct Given {
  double start, duration;  ///< of the flight [s]
  double time;             ///< that was said [s]
  double off;              ///< the way from there to the pass [m]
  double off_since;        ///< the same, if the time counts from the start [m]
  double price;            ///< questions, as a share of what is allowed
  bool cut_off;            ///< whether there were so many that nothing pulled any more
};

/// Whether a question was for just this time.
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
