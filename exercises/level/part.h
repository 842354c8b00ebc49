// SPDX-License-Identifier: MIT-0
/// @file
/// The level that a student's headers keep running: its parts, and how each is tried for an hour.
#pragma once
#include <random>
#include <string>
#include <vector>

#include "judge/student.h"

namespace level {

constexpr double h = 1.0 / 60;       ///< the game's step [s]
constexpr double on_each = 20 * 60;  ///< how long each screen is played on [s]: an hour in all
constexpr int steps = static_cast<int>(3 * on_each * 60);

/// Numbers that come from the seed of the session, the same for all parts.
class Drawn {
 public:
  Drawn();
  double between(double low, double high);

 private:
  std::mt19937_64 numbers_;
};

/// A screen that the level is played on.
struct Screen {
  std::string name;
  std::vector<double> frames;  ///< how long each takes [s]
};

/// Sixty frames a second, thirty, and uneven ones with a hitch now and then; they come from the
/// seed.
std::vector<Screen> screens();

/// What an hour has shown.
struct Hour {
  bool whole = true;       ///< nothing has exploded: all is finite, and where it can be
  double off = 0;          ///< farthest from where it should be [m]
  std::string where;       ///< it was that; empty if nothing is to be said
  double evaluations = 0;  ///< of the acceleration in a frame; of several runs the most; 0 if none

  /// Notes how far it is off, if that is the farthest yet; what is not a number is no place.
  void hold(double so_far_off, const std::string& there);
};

/// The places of a thing's points in each frame, in the picture of the film.
using Paths = std::vector<std::vector<Vec>>;

/// How the film shows the last of a thing's points.
enum class Look { ball, frame, post, trail };

/// One of the level's things.
struct Part {
  std::string exercise, name, does;
  double most_evaluations = 0;  ///< in a frame; 0 if none is asked for
  Hour (*hour)(judge::Student& yours, judge::Student& right) = nullptr;
  Paths (*paths)(judge::Student& whose, const std::vector<double>& frames) = nullptr;
  Look look = Look::ball;
};

constexpr double most_off = 0.01;  ///< what a producer allows [m]

/// The parts, in the book's order.
const std::vector<Part>& parts();

/// Returns whether a producer is content.
bool is_kept(const Part& part, const Hour& hour);

}  // namespace level
