// SPDX-License-Identifier: MIT-0
/// @file
/// Frames on a screen, and what a wrong clock shows in them.
#pragma once
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "format_values.h"

namespace judge::leftover_time {

struct Frame {
  double length, pace = 1;  ///< of the player's time [s]; game time in the player's
};

/// Frames of one clock.
struct Level {
  double h;
  std::vector<Frame> frames;
  double saved = 0;  ///< before the first of them [s]
};

constexpr double hitch =
    0.2;  ///< and longer is a frame in which the machine did something else [s]

/// The state after a frame: all steps up to here, how far the picture is towards the next, and what
/// is saved [s].
struct After {
  double steps, blend, saved;
  double picture() const { return steps + blend; }
};

inline std::string described(const Frame& frame) {
  const std::string length = grade::number(frame.length, 17);
  return frame.pace == 1 ? length : length + " (pace " + grade::number(frame.pace, 17) + ")";
}

/// Says what a limit on the frame throws away, if that is the first thing that is wrong.
inline std::string cut_short(const std::vector<After>& got, const Level& level,
                             const std::vector<double>& time) {
  const double h = level.h;
  std::size_t n = 0;
  while (n < got.size() && std::abs(got[n].picture() - time[n] / h) < 1e-6) ++n;
  if (n == got.size()) return "";
  const Frame& frame = level.frames[n];
  const double due = frame.pace * frame.length;
  if (std::max(due, frame.length) < hitch) return "";
  const double went = (got[n].picture() - (n > 0 ? got[n - 1].picture() : level.saved / h)) * h;
  if (went <= 10 * h || went > due - h / 2) return "";
  return "of " + grade::number(due, 6) + " s of the game in one frame only " +
         grade::number(went, 6) + " s go by: no limit on a frame may throw time away here";
}

/// Mistakes that show only in many frames.
inline std::vector<std::string> of_many_frames(const std::vector<After>& got,
                                               const std::vector<double>& time, double h) {
  std::vector<std::string> found;
  if (got.size() < 20) return found;
  const double pace = got.back().picture() * h / time.back();
  if (std::abs(pace - 1) > 0.2) {
    found.push_back("the game runs at " + grade::number(pace, 3) + " times its speed");
  }
  const auto always = [&](auto is) { return std::all_of(got.begin(), got.end(), is); };
  if (always([](const After& now) { return now.blend == 0; })) {
    found.push_back("the blend is always 0: nothing is left over after a frame");
  }
  return found;
}

inline std::vector<std::string> what_is_wrong(const std::vector<After>& got, const Level& level,
                                              const std::vector<double>& time) {
  if (const std::string cut = cut_short(got, level, time); !cut.empty()) return {cut};
  return of_many_frames(got, time, level.h);
}

}  // namespace judge::leftover_time
