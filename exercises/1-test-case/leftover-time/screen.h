// SPDX-License-Identifier: MIT-0
/// @file
/// Frames on a screen, and what a wrong clock shows in them.
#pragma once
#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "format_values.h"
#include "judge/diagnose.h"

namespace judge::leftover_time {

struct Frame {
  double length, pace = 1;  ///< of the player's time [s]; game time in the player's
};

constexpr double hitch =
    0.2;  ///< and longer is a frame in which the machine did something else [s]

/// After a frame: all steps up to here, how far the picture is towards the next, and what is saved
/// [s].
struct After {
  double steps, blend, saved;
  double picture() const { return steps + blend; }
};

inline std::string described(const Frame& frame) {
  const std::string length = grade::number(frame.length, 17);
  return frame.pace == 1 ? length : length + " (pace " + grade::number(frame.pace, 17) + ")";
}

/// Steps due in a frame, by a clock that is told what to save.
using Clock = std::function<double(double& saved, const Frame& frame, double h)>;

inline double spend(double& saved, double added, double price) {
  saved += added;
  const double steps = std::isfinite(price) ? std::floor(saved / price) : 0;
  if (steps > 0) saved -= steps * price;
  return steps;
}

/// Whether a clock shows what came, in all frames.
inline bool shows(const Clock& clock, const std::vector<After>& got,
                  const std::vector<Frame>& frames, double h) {
  double saved = 0, steps = 0;
  for (std::size_t n = 0; n < frames.size(); ++n) {
    steps += clock(saved, frames[n], h);
    if (!(std::abs(steps + saved / h - got[n].picture()) < 1e-6)) return false;
  }
  return true;
}

inline std::vector<std::string> of_the_pace(const std::vector<After>& got,
                                            const std::vector<Frame>& frames, double h) {
  if (std::ranges::all_of(frames, [](const Frame& frame) { return frame.pace == 1; })) return {};
  const std::vector<std::pair<Clock, const char*>> known{
      {[](double& saved, const Frame& frame, double step) {
         return spend(saved, frame.length, step);
       },
       "the pace has no effect: the picture follows the player's time"},
      {[](double& saved, const Frame& frame, double step) {
         return spend(saved, frame.length, step / frame.pace);
       },
       "the player's time is saved here, and the blend takes it for the game's"},
      {[](double& saved, const Frame& frame, double step) {
         return frame.pace == 0 ? 0 : spend(saved, frame.length, step / frame.pace);
       },
       "the player's time is saved here, and the blend takes it for the game's"},
      {[](double& saved, const Frame& frame, double step) {
         saved = frame.pace * (saved + frame.length);
         return spend(saved, 0, step);
       },
       "what is left over is game time already, and here each frame multiplies it by its pace"},
      {[](double& saved, const Frame& frame, double step) {
         return spend(saved, frame.length / (frame.pace == 0 ? 1 : frame.pace), step);
       },
       "the frame is divided by its pace, and not multiplied: slow motion is faster here"},
      {[](double& saved, const Frame& frame, double step) {
         if (frame.pace == 0) saved = 0;
         return spend(saved, frame.pace * frame.length, step);
       },
       "a pause throws away what was left over, and the picture jumps back"},
      {[](double& saved, const Frame& frame, double step) {
         return spend(saved, frame.pace * frame.pace * frame.length, step);
       },
       "the pace counts twice"},
      {[](double& saved, const Frame& frame, double step) {
         return std::trunc(frame.pace * spend(saved, frame.length, step));
       },
       "the steps are made fewer after their time was spent: a part of one step is none"}};
  for (const auto& [clock, says] : known)
    if (shows(clock, got, frames, h)) return {says};
  return {};
}

/// What a limit on the frame throws away, if that is the first thing that is wrong.
inline std::string cut_short(const std::vector<After>& got, const std::vector<Frame>& frames,
                             const std::vector<double>& time, double h) {
  std::size_t n = 0;
  while (n < got.size() && std::abs(got[n].picture() - time[n] / h) < 1e-6) ++n;
  if (n == got.size() || frames[n].length < hitch) return "";
  const double went = (got[n].picture() - (n > 0 ? got[n - 1].picture() : 0)) * h;
  const double due = frames[n].pace * frames[n].length;
  if (went <= 0 || went > due - h / 2) return "";
  return "of a frame of " + grade::number(due, 3) + " s only " + grade::number(went, 3) +
         " s go by: no limit on a frame may throw time away here";
}

/// Whether the picture is right, and what is saved is how far it has come.
inline bool saves_steps(const std::vector<After>& got, const std::vector<double>& time, double h) {
  for (std::size_t n = 0; n < got.size(); ++n) {
    if (!(std::abs(got[n].picture() - time[n] / h) < 1e-6)) return false;
    if (!(std::abs(got[n].saved - got[n].blend) < 1e-6)) return false;
  }
  return true;
}

inline double most_in_a_frame(const std::vector<After>& got) {
  double most = got.front().steps;
  for (std::size_t n = 1; n < got.size(); ++n) {
    most = std::max(most, got[n].steps - got[n - 1].steps);
  }
  return most;
}

inline bool forgets_the_frame_before(const std::vector<After>& got, const std::vector<double>& time,
                                     double h) {
  for (std::size_t n = 1; n < got.size(); ++n) {
    const double taken = got[n].steps - got[n - 1].steps;
    if (taken != std::floor((time[n] - time[n - 1]) / h)) return false;
  }
  return true;
}

/// Whether the blend is 1 after frames that last just so many steps.
inline bool leaves_a_step(const std::vector<After>& got, const std::vector<double>& time,
                          double h) {
  for (std::size_t n = 0; n < got.size(); ++n)
    if (got[n].blend != 1 || got[n].picture() != time[n] / h) return false;
  return true;
}

inline std::vector<std::string> recognise(const std::vector<After>& got,
                                          const std::vector<Frame>& frames,
                                          const std::vector<double>& time, double h) {
  const double pace = got.back().picture() * h / time.back();
  const double a_frame = got.back().steps / static_cast<double>(got.size());
  if (saves_steps(got, time, h))
    return {"what is saved is in steps here; it is asked for in seconds of the game"};
  std::vector<std::string> found = of_the_pace(got, frames, h);
  if (!found.empty()) return found;
  if (const std::string cut = cut_short(got, frames, time, h); !cut.empty()) return {cut};
  if (leaves_a_step(got, time, h))
    return {"a blend of 1: the step was due in this frame, and nothing would be left over"};
  if (std::abs(pace - 1) > 0.01) {
    found.push_back("the game runs at " + grade::number(pace, 3) + " times its speed");
  }
  if (std::abs(pace / 1000 - 1) < 0.01) found.push_back("milliseconds where seconds are meant?");
  if (std::abs(pace - 1) > 0.01 && std::abs(a_frame - 1) < 0.02) {
    found.push_back("about one step in every frame: the steps follow the frames");
  }
  const auto always = [&](auto is) { return std::all_of(got.begin(), got.end(), is); };
  if (always([](const After& now) { return now.blend == 0; })) {
    found.push_back("the blend is always 0: nothing is left over after a frame");
  }
  if (always([](const After& now) { return now.blend == 1; })) {
    found.push_back("the blend is always 1: this shows the newest state, not one between two");
  }
  if (std::any_of(got.begin(), got.end(), [](const After& now) { return now.blend < -1e-9; })) {
    found.push_back("a blend below 0: more steps were taken than were due");
  }
  if (most_in_a_frame(got) == 1 && time.back() / h > 1.1 * static_cast<double>(got.size())) {
    found.push_back("never more than one step in a frame, and here more are due");
  }
  if (forgets_the_frame_before(got, time, h)) {
    found.push_back(
        "each frame takes the steps that fit into it alone: what the one before left over is lost");
  }
  const double part = time.front() / h - got.front().steps, blend = got.front().blend;
  if (std::abs(blend - (1 - part)) < 1e-9 && std::abs(blend - part) > 1e-3) {
    found.push_back(
        "the blend says how far it still is to the newer state; how far it has come was asked");
  }
  if (std::abs(blend - part * h) < 1e-9) {
    found.push_back("the blend is in seconds; as a share of a step it would be from 0 to 1");
  }
  const double first = std::abs(got.front().picture() * h / time.front() - 1);
  if (like_a_float(first)) found.push_back("right to seven digits and no further: a float?");
  return found;
}

}  // namespace judge::leftover_time
