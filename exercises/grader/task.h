// SPDX-License-Identifier: MIT-0
/// @file
/// The head of a task.md.
#pragma once
#include <string>

#include "exercise.h"

namespace grade {

struct Task {
  std::string title, goal, kind, difficulty, minutes;  ///< empty if there is no task.md
};

Task task(const Exercise& exercise);

/// A line for each exercise, in the book's order: its name, kind, difficulty from 1 to 3, minutes
/// and title, with a mark before what is done.
/// @param part  of the names; empty for all
std::string list_of_exercises(const std::string& part);

}  // namespace grade
