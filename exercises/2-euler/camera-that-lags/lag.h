// SPDX-License-Identifier: MIT-0
/// @file
/// How far a camera goes in a frame, and how far it would by other rules.
#pragma once
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "format_values.h"
#include "harness/given.h"
#include "judge/diagnose.h"

/// How a camera lags.
struct Lag {
  double part;           ///< of the way that it goes in a sixtieth of a second
  double fastest = 1e6;  ///< [m/s]

  double rate() const { return -60 * std::log1p(-part); }  ///< [1/s]
  double left(double time) const { return std::pow(1 - part, 60 * time); }

  /// How much of a frame it is as fast as it may be, if it slows down at this distance [s].
  double flat_out(double distance, double border, double frame) const {
    return std::clamp((distance - border) / fastest, 0.0, frame);
  }

  /// The distance after a frame, if it slows down at this one.
  double after(double distance, double border, double frame) const {
    const double time = flat_out(distance, border, frame);
    return (distance - fastest * time) * left(frame - time);
  }

  double after(double distance, double frame) const {
    return after(distance, fastest / rate(), frame);
  }

  Vec follow(const Vec& camera, const Vec& target, double frame) const {
    const double distance = length(camera - target);
    return distance > 0 ? target + after(distance, frame) / distance * (camera - target) : target;
  }
};

inline std::string described(const Lag& lag) {
  return "part " + grade::number(lag.part, 17) + ", fastest " + grade::number(lag.fastest, 17);
}

/// The way that a camera would go by other rules, of a way that is left [m], where that limit
/// counts.
inline std::vector<std::pair<double, std::string>> of_the_limit(const Lag& lag, double distance,
                                                                double frame) {
  const double most = lag.fastest * frame, border = lag.fastest / lag.rate();
  if (distance <= border) return {};
  const double lagging = distance * (1 - lag.left(frame));
  const bool fast = lagging > most;
  return {
      {lagging, fast ? "it goes as if nothing limited its speed, or only the speed along each axis"
                     : "on the mean of the frame it is slow enough, but at first it is too fast"},
      {std::min(most, distance),
       "it is as fast as it may be for the whole frame, as where a step is cut at fastest times "
       "the frame; but within it, it comes so near that it slows down"},
      {distance - border,
       "it stops where it begins to slow down: the rest of the frame is missing"},
      {distance - border * lag.left(frame),
       "it slows down where it should; but for that the whole frame was taken, and only a part "
       "of it is left there"},
      {distance - lag.after(distance, lag.fastest / (60 * lag.part), frame),
       "it slows down at fastest / (60 part); but it lags at the rate -60 log(1 - part)"},
      {std::min(most, 60 * frame * lag.part * distance),
       "a step of Euler's method, cut at fastest times the frame"}};
}

/// The share of the way that it would go, where nothing limits it.
inline std::vector<std::pair<double, std::string>> of_the_lag(const Lag& lag, double frame) {
  const double part = lag.part;
  return {
      {0, "the camera does not move"},
      {1, "the camera is at its target at once"},
      {part, "each frame goes the part, however long it is"},
      {60 * frame * part, "a step of Euler's method: the way is in proportion to the frame"},
      {1 - std::exp(-60 * frame * part),
       "the part is taken for a rate; at sixty frames a second this goes " +
           grade::number(1 - std::exp(-part)) + " of the way instead of " + grade::number(part)},
      {1 - lag.left(frame / 60),
       "the part is taken for the way of a second; it is the way of a sixtieth"},
      {1 - std::pow(part, 60 * frame),
       "the part of the way that it goes is taken for the part that is left"}};
}

/// Whether each axis was limited by itself.
inline bool limits_each_axis(const Lag& lag, const Vec& way, double frame, const Vec& went) {
  const double most = lag.fastest * frame, share = 1 - lag.left(frame);
  const auto cut = [&](double along) { return std::clamp(share * along, -most, most); };
  return length(went - Vec{cut(way.x), cut(way.y), cut(way.z)}) < 1e-10 * length(way) &&
         length(went - share * way) > 1e-10 * length(way);
}

inline std::vector<std::string> recognise(const Lag& lag, const Vec& before, const Vec& target,
                                          double frame, const Vec& got) {
  if (!std::isfinite(got.x) || !std::isfinite(got.y) || !std::isfinite(got.z))
    return {"this is not a finite place: a division by zero?"};
  const Vec way = target - before;
  if (length(way) == 0) return {"a camera at its target has nowhere to go"};
  const double distance = length(way), went = dot(got - before, way) / dot(way, way);
  const double off = std::abs(went - 1 + lag.after(distance, frame) / distance);
  if (went > 1 + 1e-12) {
    return {"the camera is beyond its target, at " + grade::number(went, 4) + " times the way"};
  }
  if (judge::like_a_float(off)) {
    return {"right to seven digits: a float, or a constant with an f, or a jump at the end?"};
  }
  if (limits_each_axis(lag, way, frame, got - before)) {
    return {"each axis is limited by itself, which turns the way and lets the camera be faster"};
  }
  const auto alone = [&](double axis) {
    return std::copysign(std::abs(axis) - lag.after(std::abs(axis), frame), axis);
  };
  const Vec bent = got - before - went * way;
  if (length(got - before - Vec{alone(way.x), alone(way.y), alone(way.z)}) < 1e-10 * distance &&
      length(bent) > 1e-10 * distance) {
    return {"each axis is limited by itself, which turns the way and lets the camera be faster"};
  }
  if (length(bent) > 1e-6 * distance)
    return {"the camera does not move straight at its target: it is " +
            grade::number(length(bent), 3) + " m beside the line"};
  for (const auto& [other, says] : of_the_limit(lag, distance, frame)) {
    if (std::abs(went - other / distance) < 1e-10) return {says};
  }
  for (const auto& [other, says] : of_the_lag(lag, frame)) {
    if (std::abs(other - 1 + lag.left(frame)) < 1e-10) continue;  // in this frame it is right
    if (std::abs(went - other) < 1e-10) return {says};
  }
  if (went <= 0 || went >= 1) return {};
  return {"the camera went as far as it should in " +
          grade::number(std::log1p(-went) / std::log1p(-lag.part) / 60, 4) + " s"};
}
