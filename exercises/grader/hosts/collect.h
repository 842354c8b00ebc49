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
  std::filesystem::path worksheet;  ///< of Moodle, that knows the times; empty: none
};

/// Brings what a system handed out into the folder that a course reads, and the times at which it
/// was handed in into a table beside that folder, `times.csv`.
/// @returns the exit code: 0; 3 if nothing was there
/// @throws Usage  what to mend
int collect_submissions(const Collection& work);

}  // namespace grade
