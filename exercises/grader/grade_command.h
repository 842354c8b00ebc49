// SPDX-License-Identifier: MIT-0
#pragma once
#include "command_line.h"

namespace grade {

/// Exit codes of the grader.
enum Exit : int {
  graded = 0,
  below_full_score = 1,  ///< only by --exit-status verdict
  bad_input = 2,
  unreadable = 3,
  failed = 42,  ///< and will fail again
  try_again = 75,
};

/// Grades one submission, keeps the report if there is a folder for it, and prints it.
/// @returns the exit code
int grade_and_report(const Command& command);

}  // namespace grade
