// SPDX-License-Identifier: MIT-0
/// @file
/// An exercise: a folder, and the tests of the judge that bear its name.
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace grade {

struct Exercise {
  std::string name;              ///< chapter and folder: `2-euler/orbit-drift`
  std::filesystem::path folder;  ///< that holds task.md, starter.h, harness.h and judge.cpp
  std::string chapter() const;   ///< `2-euler`
  std::string task() const;      ///< `orbit-drift`
  std::string header() const;    ///< what a submission is called: `orbit-drift.h`
};

/// All exercises that this grader can judge, in the book's order.
std::vector<Exercise> exercises();

/// The exercise of that name; nothing if there is none.
std::optional<Exercise> exercise(const std::string& name);

/// The exercise whose name is most like this one, for a message.
std::string nearest_exercise(const std::string& name);

}  // namespace grade
