// SPDX-License-Identifier: MIT-0
/// @file
/// What `choose` is asked for: bounds, and the frames in which they have to hold.
#pragma once
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

#include "frames/recorded.h"

/// The bounds that a method has to meet.
struct Bounds {
  double hz = 60;            ///< frames a second
  double seconds = 10;       ///< how long the scene is watched
  double error = 0.01;       ///< largest error, as a share of how far the motion gets
  double energy = INFINITY;  ///< largest relative change of the energy
  double reach = 0;          ///< how far the motion gets, if errors are told in metres [m]

  long frames() const { return std::lround(seconds * hz); }
};

inline constexpr long most_steps = 1 << 20;  ///< in one run
inline constexpr long most_substeps = 1024;  ///< in one frame

/// The ends of frames, with the start before the first of them [s].
inline std::vector<double> even_frames(const Bounds& bounds) {
  std::vector<double> ends;
  for (long n = 0; n <= bounds.frames(); ++n) ends.push_back(double(n) / bounds.hz);
  return ends;
}

/// The ends of as many frames that are as uneven as those of `frames::recorded`, with a mean of
/// `hz` [s].
inline std::vector<double> uneven_frames(const Bounds& bounds) {
  const auto& frames = frames::recorded;
  const double sum = std::accumulate(frames.begin(), frames.end(), 0.0);
  std::vector<double> ends{0};
  for (long n = 0; n < bounds.frames(); ++n) {
    const double length = frames[std::size_t(n) % frames.size()];
    ends.push_back(ends.back() + length * double(frames.size()) / (sum * bounds.hz));
  }
  return ends;
}

/// A share of the motion in the units of the answer: a share, or metres.
inline double in_reported_units(double share, const Bounds& bounds) {
  return bounds.reach > 0 ? share * bounds.reach : share;
}
