// SPDX-License-Identifier: MIT-0
#pragma once
#include <cstddef>
#include <filesystem>
#include <string>

#include "class/class.h"

namespace grade {

/// What is to be graded of a course.
struct CourseWork {
  std::filesystem::path file;  ///< that describes it
  std::string round;           ///< the one assignment to grade; empty: all that have opened
  std::size_t jobs = 1;        ///< submissions at a time
  Shard shard;                 ///< a part of the work, after which no table is written
};

/// Grades a round or all, each into its own folder of the results; then writes the table of all
/// assignments that have been graded so far.
/// @returns the exit code
/// @throws Usage  the course's file, the roster or the table of times is wrong
int grade_course(const CourseWork& work);

}  // namespace grade
