// SPDX-License-Identifier: MIT-0
#pragma once
#include <filesystem>
#include <string>

namespace grade {

/// What is brought from where to where.
struct Collection {
  std::string kind;                 ///< `moodle` and the like
  std::filesystem::path from;       ///< that the system handed out
  std::filesystem::path to;         ///< the submissions of a course
  std::string until;                ///< a time with an offset; empty: none
  std::filesystem::path worksheet;  ///< of Moodle, that knows times and people; empty: none
  std::filesystem::path course;     ///< whose round says what still counts; empty: none
  std::string round;
};

/// Brings what a system handed out into the folder that a course reads, and what the system knows
/// of it into tables there: when it was handed in, `times.csv`, and who that is, `people.csv`.
/// @returns the exit code: 0; 3 if nothing was there
/// @throws Usage  what to mend
int collect_submissions(const Collection& work);

}  // namespace grade
