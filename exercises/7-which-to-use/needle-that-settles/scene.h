// SPDX-License-Identifier: MIT-0
/// @file
/// A needle as its equation moves it, and as other equations would.
#pragma once
#include <cmath>

#include "judge/method.h"

namespace needle {

/// A target that moves, for so long.
struct Frame {
  double target, u, h;

  double end() const { return target + u * h; }
};

struct State {
  double x, v;
};

/// A needle and its pull, with the time in units of 1/omega, so that all are equally stiff.
struct Needle {
  double omega;

  judge::Start start(const State& from) const { return {{from.x, 0, 0}, {from.v / omega, 0, 0}}; }
  State seen(const judge::State& state) const { return {state.x.x, state.v.x * omega}; }

  Acceleration pull(const Frame& frame) const {
    const double u = frame.u / omega, target = frame.target;
    return [=](const Vec& x, const Vec& v, double t) {
      return Vec{target + u * t - x.x - 2 * v.x, 0, 0};
    };
  }

  /// The state after a frame, by tiny steps; after so long that nothing is left of the start, where
  /// it follows.
  State after(const State& from, const Frame& frame) const {
    if (omega * frame.h > 60) return {frame.end() - 2 * frame.u / omega, frame.u};
    return seen(judge::truth(start(from), omega * frame.h, 1, 1, pull(frame)).states.back());
  }
};

}  // namespace needle
