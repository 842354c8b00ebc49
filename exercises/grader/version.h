// SPDX-License-Identifier: MIT-0
/// @file
/// Hashes of what was compiled in; versions.cmake writes version.cpp when any of it changes.
#pragma once
#include <string>
#include <vector>

namespace grade {

/// The version of an exercise.
struct Version {
  std::string exercise;  ///< its name
  std::string hash;  ///< the version of the book, and SHA-256 over the grader's own files and those
                     ///< of the exercise, the first sixteen digits
};

/// The versions of all exercises that this grader can judge, in the book's order.
const std::vector<Version>& versions();

}  // namespace grade
