// SPDX-License-Identifier: MIT-0
/// @file
/// A camera's lag, and its way in a frame.
#pragma once
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "format_values.h"
#include "harness/given.h"

/// The lag of a camera.
struct Lag {
  double part;           ///< of the way that it goes in a sixtieth of a second
  double fastest = 1e6;  ///< [m/s]

  double rate() const { return -60 * std::log1p(-part); }  ///< [1/s]
  double left(double time) const { return std::pow(1 - part, 60 * time); }

  /// The part of a frame in which it is as fast as it may be, if it slows down at this distance
  /// [s].
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

inline std::vector<std::string> what_is_wrong(const Lag& lag, const Vec& before, const Vec& target,
                                              const Vec& got) {
  if (!std::isfinite(got.x) || !std::isfinite(got.y) || !std::isfinite(got.z))
    return {"this is not a finite place: a division by zero?"};
  const Vec way = target - before;
  if (length(way) == 0) return {"a camera at its target has nowhere to go"};
  const double distance = length(way), went = dot(got - before, way) / dot(way, way);
  if (length(got - before) == 0) return {"the camera does not move"};
  if (went > 1 + 1e-12) {
    return {"the camera is beyond its target, at " + grade::number(went, 4) + " times the way"};
  }
  const Vec bent = got - before - went * way;
  if (length(bent) > 1e-6 * distance)
    return {"the camera does not move straight at its target: it is " +
            grade::number(length(bent), 3) + " m beside the line"};
  if (went <= 0 || went >= 1 || distance > lag.fastest / lag.rate()) return {};
  return {"the camera went as far as it should in " +
          grade::number(std::log1p(-went) / std::log1p(-lag.part) / 60, 4) + " s"};
}
