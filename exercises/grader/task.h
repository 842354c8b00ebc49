// SPDX-License-Identifier: MIT-0
/// @file
/// What the head of a task.md says.
#pragma once
#include <string>

#include "exercise.h"

namespace grade {

struct Task {
  std::string title, kind, minutes;  ///< empty if there is no task.md
};

Task task(const Exercise& exercise);

/// A line for each exercise: its name, kind, minutes, points and title.
/// @param part  of the names; empty for all
std::string list_of_exercises(const std::string& part);

}  // namespace grade
