// SPDX-License-Identifier: MIT-0
/// @file
/// What `choose` is asked for: bounds, and the frames in which they have to hold.
#pragma once
#include <cmath>
#include <cstddef>
#include <numeric>
#include <string>
#include <vector>

#include "frames/recorded.h"

/// Frames that a machine took.
struct FrameLog {
  std::string name;             ///< of its file
  std::vector<double> lengths;  ///< one after the other [s]; none: those of frames::recorded
};

/// The bounds that a method has to meet.
struct Bounds {
  double hz = 60;            ///< frames a second
  double seconds = 10;       ///< how long the scene is watched
  double error = 0.01;       ///< largest error, as a share of how far the motion gets
  double energy = INFINITY;  ///< largest relative change of the energy
  double reach = 0;          ///< how far the motion gets, if errors are told in metres [m]
  FrameLog log{};            ///< what uneven frames are

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

/// The sum of many lengths.
inline double sum_of(const std::vector<double>& lengths) {
  return std::accumulate(lengths.begin(), lengths.end(), 0.0);
}

/// Where the roughest stretch of so many frames begins: that with the largest sum of their squares,
/// the first of several; 0 if there are no more.
inline std::size_t roughest(const std::vector<double>& lengths, std::size_t many) {
  if (many >= lengths.size()) return 0;
  double sum = 0, most = 0;
  std::size_t begin = 0;
  for (std::size_t n = 0; n < lengths.size(); ++n) {
    sum += lengths[n] * lengths[n];
    if (n >= many) sum -= lengths[n - many] * lengths[n - many];
    if (n + 1 >= many && sum > most * (1 + 1e-12)) most = sum, begin = n + 1 - many;
  }
  return begin;
}

/// The ends of as many frames as uneven as those of a log, with a mean of `hz` [s]: of a log that
/// is longer its roughest stretch, and one that is shorter over and over.
inline std::vector<double> uneven_frames(const Bounds& bounds) {
  const std::vector<double> lengths =
      bounds.log.lengths.empty()
          ? std::vector<double>(frames::recorded.begin(), frames::recorded.end())
          : bounds.log.lengths;
  const double stretched = double(lengths.size()) / (sum_of(lengths) * bounds.hz);
  const std::size_t begin =
      bounds.log.lengths.empty() ? 0 : roughest(lengths, std::size_t(bounds.frames()));
  std::vector<double> ends{0};
  for (long n = 0; n < bounds.frames(); ++n)
    ends.push_back(ends.back() + lengths[(begin + std::size_t(n)) % lengths.size()] * stretched);
  return ends;
}

/// A share of the motion in the units of the answer: a share, or metres.
inline double in_reported_units(double share, const Bounds& bounds) {
  return bounds.reach > 0 ? share * bounds.reach : share;
}
