// SPDX-License-Identifier: MIT-0
/// @file
/// The scenes in which a student's code moves, one for each exercise: its play.cpp.
#pragma once
#include <functional>
#include <optional>
#include <string>

#include "home/stage.h"
#include "judge/student.h"

namespace grade {

struct Scene {
  std::string exercise;  ///< `2-euler/orbit-drift`
  std::string caption;   ///< what to see, in a sentence or two
  View view;
  /// Draws the film: what the student's code does, and what the exercise's solution does beside it.
  std::function<void(Stage&, judge::Student& yours, judge::Student& right)> film;
};

/// The scene of an exercise; null if there is none.
const Scene* scene_of(const std::string& exercise);

/// Made as the program starts, it makes a scene known.
struct Staged {
  explicit Staged(Scene scene);
};

/// Where a thing is after so many states of its path; between two of them it moves straight on.
Vec place(const judge::Path& path, double states);

}  // namespace grade
